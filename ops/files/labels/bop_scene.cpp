#include "ops/files/labels/bop_scene.h"

#include "core/picture/image_files.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

OrderedJson rows_json(const Mat3& m) {
  OrderedJson out = OrderedJson::array();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out.push_back(m(r, c));
  return out;
}

OrderedJson pixel_box_json(const LabelBox& box) {
  if (box.empty()) return {-1, -1, -1, -1};
  return {int(box.x0), int(box.y0), int(box.x1 - box.x0), int(box.y1 - box.y0)};
}

std::string mask_png(const std::vector<bool>& mask, int width, int height) {
  std::vector<std::uint8_t> grey(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) grey[i] = mask[i] ? 255 : 0;
  return encode_grey_png(width, height, std::span<const std::uint8_t>(grey));
}

OrderedJson info_json(const ObjectLabel& label) {
  const bool seen = label.num_visible > 0;
  return {{"bbox_obj", pixel_box_json(seen ? label.canvas_box : LabelBox())},
          {"bbox_visib", pixel_box_json(label.visible_box)},
          {"px_count_all", label.num_on_canvas},
          {"px_count_valid", label.num_alone},
          {"px_count_visib", label.num_visible},
          {"visib_fract", label.visible_share()}};
}

}  // namespace

OrderedJson vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

BopScene::BopScene(const LabelledScene& scene, double depth_unit, Sink sink, std::vector<int> ids)
    : m_scene(scene), m_unit(depth_unit), m_sink(std::move(sink)), m_ids(std::move(ids)) {}

void BopScene::add_target(const LabelView& view, const Labels& labels, std::size_t object) {
  const std::string key = std::to_string(m_num_images);
  const std::string file =
      number_text(m_num_images) + "_" + number_text(int(m_poses[key].size())) + ".png";
  std::vector<bool> visible(labels.instances.size());
  for (std::size_t i = 0; i < visible.size(); ++i) visible[i] = labels.instances[i] == object + 1;
  m_sink("mask_visib/" + file, mask_png(visible, labels.width, labels.height));
  m_sink("mask/" + file, mask_png(object_silhouette(m_scene.picture, object, view.camera),
                                  labels.width, labels.height));
  const LabelledObject& target = m_scene.objects[object];
  const PinholeCamera& camera = view.camera;
  m_poses[key].push_back(
      {{"cam_R_m2c", rows_json(camera.camera_from_world * target.pose.rotation.matrix())},
       {"cam_t_m2c", vector_json(kMillimetres * camera.apply(target.pose.translation))},
       {"obj_id",
        m_ids.empty() ? target.model_id : m_ids[static_cast<std::size_t>(target.model_id) - 1]}});
  m_infos[key].push_back(info_json(labels.objects[object]));
}

void BopScene::add(const LabelView& view, const Labels& labels, const std::string& picture) {
  const std::string file = number_text(m_num_images) + ".png", key = std::to_string(m_num_images);
  if (!picture.empty()) m_sink("rgb/" + file, picture);
  m_sink("depth/" + file,
         encode_grey_png(labels.width, labels.height,
                         std::span<const std::uint16_t>(depth_in_units(labels, m_unit).units)));
  const PinholeCamera& c = view.camera;
  m_cameras[key] = {{"cam_K", {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}},
                    {"depth_scale", m_unit * kMillimetres},
                    {"cam_R_w2c", rows_json(c.camera_from_world)},
                    {"cam_t_w2c", vector_json(-kMillimetres * c.rotate(c.eye))}};
  m_poses[key] = OrderedJson::array();
  m_infos[key] = OrderedJson::array();
  for (std::size_t i = 0; i < labels.objects.size(); ++i)
    if (m_scene.objects[i].is_target()) add_target(view, labels, i);
  ++m_num_images;
}

void BopScene::finish() {
  m_sink("scene_camera.json", readable_json(m_cameras));
  m_sink("scene_gt.json", readable_json(m_poses));
  m_sink("scene_gt_info.json", readable_json(m_infos));
}

OrderedJson bop_camera_json(const PinholeCamera& c, double depth_unit) {
  return {{"cx", c.cx},      {"cy", c.cy}, {"depth_scale", depth_unit * kMillimetres},
          {"fx", c.fx},      {"fy", c.fy}, {"height", c.height},
          {"width", c.width}};
}

}  // namespace trivet
