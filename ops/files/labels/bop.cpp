#include <cmath>

#include "core/io/export.h"
#include "core/io/staged_files.h"
#include "core/mesh/hull.h"
#include "core/model/exported_floats.h"
#include "core/picture/image_files.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

constexpr double kMillimetres = 1000;

OrderedJson rows_json(const Mat3& m) {
  OrderedJson out = OrderedJson::array();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out.push_back(m(r, c));
  return out;
}

OrderedJson vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Whole pixels that the box holds, as BOP's boxes of masks: x, y, width, height.
OrderedJson pixel_box_json(const LabelBox& box) {
  const double x0 = std::ceil(box.x0), y0 = std::ceil(box.y0);
  const double w = std::floor(box.x1) - x0 + 1, h = std::floor(box.y1) - y0 + 1;
  if (box.empty() || w < 1 || h < 1) return {-1, -1, -1, -1};
  return {int(x0), int(y0), int(w), int(h)};
}

// Largest distance of two points. Quadratic in those of the hull.
double diameter(const std::vector<Vec3>& points) {
  std::vector<Vec3> corners;
  for (const Index v : convex_hull(points).vertices) corners.push_back(points[v]);
  if (corners.empty()) corners = points;  // flat
  double squared = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      squared = std::max(squared, (corners[i] - corners[j]).squaredNorm());
  return std::sqrt(squared);
}

std::string mask_png(const std::vector<bool>& mask, int width, int height) {
  std::vector<std::uint8_t> grey(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) grey[i] = mask[i] ? 255 : 0;
  return encode_grey_png(width, height, std::span<const std::uint8_t>(grey));
}

class BopWriter : public DataSetWriter {
 public:
  BopWriter(const std::string& folder, const LabelledScene& scene, double depth_unit)
      : m_folder(folder), m_views(folder + "/000000"), m_scene(scene), m_unit(depth_unit) {
    for (const char* part : {"rgb", "depth", "mask", "mask_visib"})
      m_files.add_folder(m_views + "/" + part);
    m_files.add_folder(m_folder + "/models");
  }

  void add(const LabelView& view, const Labels& labels, const std::string& picture) override;
  void finish() override;

 private:
  void write_masks(const LabelView& view, const Labels& labels, std::size_t object);
  OrderedJson pose_json(const LabelView& view, const LabelledObject& object) const;
  OrderedJson write_model(const std::string& name, const LabelledModel& model);

  std::string m_folder, m_views;
  const LabelledScene& m_scene;
  double m_unit;
  StagedFiles m_files;
  int m_num_images = 0;
  OrderedJson m_first_camera;
  OrderedJson m_cameras = OrderedJson::object(), m_poses = OrderedJson::object(),
              m_infos = OrderedJson::object();
};

OrderedJson BopWriter::pose_json(const LabelView& view, const LabelledObject& object) const {
  const PinholeCamera& camera = view.camera;
  return {{"cam_R_m2c", rows_json(camera.camera_from_world * object.pose.rotation.matrix())},
          {"cam_t_m2c", vector_json(kMillimetres * camera.apply(object.pose.translation))},
          {"obj_id", object.model_id}};
}

void BopWriter::write_masks(const LabelView& view, const Labels& labels, std::size_t object) {
  const std::string file = number_text(m_num_images) + "_" + number_text(int(object)) + ".png";
  std::vector<bool> visible(labels.instances.size());
  for (std::size_t i = 0; i < visible.size(); ++i) visible[i] = labels.instances[i] == object + 1;
  m_files.add(m_views + "/mask_visib/" + file, mask_png(visible, labels.width, labels.height));
  m_files.add(m_views + "/mask/" + file,
              mask_png(object_silhouette(m_scene.picture, object, view.camera), labels.width,
                       labels.height));
}

void BopWriter::add(const LabelView& view, const Labels& labels, const std::string& picture) {
  const std::string file = number_text(m_num_images) + ".png", key = std::to_string(m_num_images);
  m_files.add(m_views + "/rgb/" + file, picture);
  m_files.add(
      m_views + "/depth/" + file,
      encode_grey_png(labels.width, labels.height,
                      std::span<const std::uint16_t>(depth_in_units(labels, m_unit).units)));
  const PinholeCamera& c = view.camera;
  const double depth_scale = m_unit * kMillimetres;
  if (m_num_images == 0)
    m_first_camera = {{"cx", c.cx},      {"cy", c.cy}, {"depth_scale", depth_scale},
                      {"fx", c.fx},      {"fy", c.fy}, {"height", c.height},
                      {"width", c.width}};
  m_cameras[key] = {{"cam_K", {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}},
                    {"depth_scale", depth_scale},
                    {"cam_R_w2c", rows_json(c.camera_from_world)},
                    {"cam_t_w2c", vector_json(-kMillimetres * c.rotate(c.eye))}};
  OrderedJson poses = OrderedJson::array(), infos = OrderedJson::array();
  for (std::size_t i = 0; i < labels.objects.size(); ++i) {
    const ObjectLabel& label = labels.objects[i];
    poses.push_back(pose_json(view, m_scene.objects[i]));
    infos.push_back({{"bbox_obj", pixel_box_json(label.whole_box)},
                     {"bbox_visib", pixel_box_json(label.visible_box)},
                     {"px_count_all", label.num_on_canvas},
                     {"px_count_valid", label.num_alone},
                     {"px_count_visib", label.num_visible},
                     {"visib_fract", label.visible_share()}});
    write_masks(view, labels, i);
  }
  m_poses[key] = std::move(poses), m_infos[key] = std::move(infos);
  ++m_num_images;
}

OrderedJson BopWriter::write_model(const std::string& name, const LabelledModel& model) {
  ExportObject object{name, model.model, model.metres_from_file, ""};
  object.world_from_object.linear *= kMillimetres;
  ExportScene scene;
  scene.objects.push_back(object);
  m_files.add(m_folder + "/models/" + name + ".ply", scene_bytes(scene, ".ply"));
  std::vector<Vec3> points;
  Aabb box;
  for (const Vec3& v : model.model->mesh.vertices) {
    points.push_back(object.world_from_object.apply(v));
    box.extend(points.back());
  }
  const Vec3 size = box.upper - box.lower;
  return {{"diameter", diameter(points)},
          {"min_x", box.lower.x()},
          {"min_y", box.lower.y()},
          {"min_z", box.lower.z()},
          {"size_x", size.x()},
          {"size_y", size.y()},
          {"size_z", size.z()}};
}

void BopWriter::finish() {
  OrderedJson models = OrderedJson::object();
  for (std::size_t i = 0; i < m_scene.models.size(); ++i)
    models[std::to_string(i + 1)] =
        write_model("obj_" + number_text(int(i) + 1), m_scene.models[i]);
  m_files.add(m_folder + "/models/models_info.json", readable_json(models));
  m_files.add(m_folder + "/camera.json", readable_json(m_first_camera));
  m_files.add(m_views + "/scene_camera.json", readable_json(m_cameras));
  m_files.add(m_views + "/scene_gt.json", readable_json(m_poses));
  m_files.add(m_views + "/scene_gt_info.json", readable_json(m_infos));
  m_files.commit();
}

}  // namespace

std::unique_ptr<DataSetWriter> make_bop_writer(const std::string& folder,
                                               const LabelledScene& scene, double depth_unit) {
  return std::make_unique<BopWriter>(folder, scene, depth_unit);
}

}  // namespace trivet
