#include "ops/files/labels/label_json.h"

#include <cmath>

#include "ops/files/json/json_text.h"

namespace trivet {
namespace {

OrderedJson matrix_json(const PinholeCamera& camera) {
  const Vec3 t = -camera.rotate(camera.eye);
  OrderedJson rows = OrderedJson::array();
  for (int r = 0; r < 3; ++r) {
    const auto& m = camera.camera_from_world;
    rows.push_back({m(r, 0), m(r, 1), m(r, 2), t[r]});
  }
  rows.push_back({0, 0, 0, 1});
  return rows;
}

OrderedJson object_json(const LabelledObject& object, const ObjectLabel& label, int instance,
                        bool visibility) {
  OrderedJson json = {{"name", object.name},
                      {"instance", instance},
                      {"class", object.class_name},
                      {"class_id", object.class_id}};
  if (!object.attributes.empty()) json["attributes"] = OrderedJson::parse(object.attributes);
  json["box_visible"] = visible_box_json(label.visible_box);
  json["box_whole"] = whole_box_json(label.whole_box);
  json["pixels_visible"] = label.num_visible;
  if (visibility) {
    json["pixels_alone"] = label.num_alone;
    json["visible_share"] = label.visible_share();
  }
  return json;
}

}  // namespace

OrderedJson camera_json(const PinholeCamera& camera) {
  return {{"convention",
           "OpenCV: x right, y down, z forward; the centre of pixel (i, j) is at (i, j); metres"},
          {"width", camera.width},
          {"height", camera.height},
          {"K", {{camera.fx, 0, camera.cx}, {0, camera.fy, camera.cy}, {0, 0, 1}}},
          {"camera_from_world", matrix_json(camera)}};
}

OrderedJson visible_box_json(const LabelBox& box) {
  if (box.empty()) return nullptr;
  return {box.x0, box.y0, box.x1 - box.x0 + 1, box.y1 - box.y0 + 1};
}

OrderedJson whole_box_json(const LabelBox& box) {
  if (box.empty()) return nullptr;
  return {box.x0 + 0.5, box.y0 + 0.5, box.x1 - box.x0, box.y1 - box.y0};
}

OrderedJson labels_json(const LabelledScene& scene, const LabelView& view, const Labels& labels,
                        bool visibility) {
  OrderedJson json = {{"view", view.name}, {"camera", camera_json(view.camera)}};
  json["floor_instance"] = kFloorInstance;
  json["classes"] = OrderedJson::array();
  for (std::size_t i = 0; i < scene.classes.size(); ++i)
    json["classes"].push_back({{"id", i + 1}, {"name", scene.classes[i]}});
  json["objects"] = OrderedJson::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    json["objects"].push_back(
        object_json(scene.objects[i], labels.objects[i], static_cast<int>(i) + 1, visibility));
  return json;
}

std::vector<std::uint16_t> class_mask(const LabelledScene& scene, const Labels& labels) {
  std::vector<std::uint16_t> classes(labels.instances.size());
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::uint16_t id = labels.instances[i];
    if (id != kNoInstance && id != kFloorInstance)
      classes[i] = static_cast<std::uint16_t>(scene.objects[id - 1].class_id);
  }
  return classes;
}

DepthImage depth_in_units(const Labels& labels, double unit) {
  DepthImage out;
  out.units.resize(labels.depth.size());
  for (std::size_t i = 0; i < labels.depth.size(); ++i) {
    const double units = std::floor(labels.depth[i] / unit + 0.5);
    if (units <= 65535)
      out.units[i] = static_cast<std::uint16_t>(units);
    else
      ++out.num_beyond;
  }
  return out;
}

std::vector<std::uint16_t> packed_normals(const Labels& labels) {
  std::vector<std::uint16_t> out(3 * labels.normals.size());
  for (std::size_t i = 0; i < labels.normals.size(); ++i) {
    if (labels.instances[i] == kNoInstance) continue;
    for (int k = 0; k < 3; ++k)
      out[3 * i + k] =
          static_cast<std::uint16_t>(std::floor(labels.normals[i][k] * 32767.0 + 32767.5));
  }
  return out;
}

}  // namespace trivet
