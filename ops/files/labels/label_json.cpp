#include "ops/files/labels/label_json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "ops/files/json/text.h"
#include "ops/files/json/values.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

OrderedJson matrix_json(const Mat3& m, const Vec3& t) {
  OrderedJson rows = OrderedJson::array();
  for (int r = 0; r < 3; ++r) rows.push_back({m(r, 0), m(r, 1), m(r, 2), t[r]});
  rows.push_back({0, 0, 0, 1});
  return rows;
}

OrderedJson object_json(const LabelledObject& object, const LabelView& view,
                        const ObjectLabel& label, int instance, bool visibility) {
  OrderedJson json = {{"name", object.name},
                      {"instance", instance},
                      {"class", object.class_name},
                      {"class_id", object.class_id},
                      {"target", object.is_target()}};
  if (object.is_target()) json["model_id"] = object.model_id;
  const Rotation& r = object.pose.rotation;
  const Vec3& t = object.pose.translation;
  json["position"] = {t.x(), t.y(), t.z()};
  json["rotation"] = {r.w, r.x, r.y, r.z};
  json["camera_from_object"] = pose_json(view.camera, object.pose);
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

int pixels(const JsonPlace& place, const char* key, int otherwise) {
  const auto value = place.find(key);
  return value ? read_pixels(*value) : otherwise;
}

PinholeCamera aimed_camera(const JsonPlace& place, int width, int height) {
  place.expect_object({"eye", "target"}, {"name", "width", "height", "up", "fov_deg"});
  Camera camera;
  camera.eye = read_position(place.at("eye"));
  camera.target = read_position(place.at("target"));
  if (const auto up = place.find("up")) camera.up = read_position(*up);
  if (const auto fov = place.find("fov_deg")) camera.fov_deg = fov->number(1, 170);
  return pinhole_camera(camera, width, height);
}

std::vector<std::vector<double>> rows(const JsonPlace& place, std::size_t least, std::size_t most,
                                      std::size_t columns) {
  std::vector<std::vector<double>> out;
  for (const JsonPlace& row : place.items()) out.push_back(row.numbers(columns));
  if (out.size() < least || out.size() > most)
    place.refuse(
        say("a matrix of %1%2 rows", least, most > least ? say(" or %1", most) : Sentence()));
  return out;
}

PinholeCamera measured_camera(const JsonPlace& place, int width, int height) {
  place.expect_object({"K", "camera_from_world"}, {"name", "width", "height", "convention"});
  const auto k = rows(place.at("K"), 3, 3, 3);
  const auto m = rows(place.at("camera_from_world"), 3, 4, 4);
  if (k[0][1] != 0 || k[1][0] != 0 || k[2] != std::vector<double>{0, 0, 1})
    place.at("K").refuse("[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]");
  if (m.size() == 4 && m[3] != std::vector<double>{0, 0, 0, 1})
    place.at("camera_from_world").refuse("[0, 0, 0, 1] as fourth row, or none");
  PinholeCamera camera;
  camera.width = width, camera.height = height;
  camera.fx = k[0][0], camera.fy = k[1][1], camera.cx = k[0][2], camera.cy = k[1][2];
  Vec3 translation;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) camera.camera_from_world(r, c) = m[r][c];
    translation[r] = m[r][3];
  }
  camera.eye = -(camera.camera_from_world.transpose() * translation);
  return camera;
}

// Becomes a part of file names, before endings that begin with a point.
std::string read_view_name(const JsonPlace& place) {
  constexpr std::size_t kMaxName = 64;
  std::string name = place.text();
  const bool accepted =
      name.size() <= kMaxName && std::all_of(name.begin(), name.end(), [](char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               c == '_' || c == '-';
      });
  if (!accepted)
    place.refuse(say(
        "1 to %1 letters a to z and A to Z, digits, _ and -, as it becomes a part of file names",
        kMaxName));
  return name;
}

LabelView read_view(const JsonPlace& place, const std::string& name, int default_width,
                    int default_height) {
  if (!place.value().is_object()) place.refuse("an object");
  const int width = pixels(place, "width", default_width);
  const int height = pixels(place, "height", default_height);
  LabelView view{name, {}};
  if (const auto given = place.find("name")) view.name = read_view_name(*given);
  try {
    view.camera = place.find("K") ? measured_camera(place, width, height)
                                  : aimed_camera(place, width, height);
    check_camera(view.camera);
  } catch (const Error& error) {
    if (std::string(error.what()).rfind(place.where(), 0) == 0) throw;
    place.fail(error.sentence());
  }
  return view;
}

}  // namespace

OrderedJson camera_json(const PinholeCamera& camera) {
  return {{"convention",
           "OpenCV: x right, y down, z forward; the centre of pixel (i, j) is at (i, j); metres"},
          {"width", camera.width},
          {"height", camera.height},
          {"K", {{camera.fx, 0, camera.cx}, {0, camera.fy, camera.cy}, {0, 0, 1}}},
          {"camera_from_world", matrix_json(camera.camera_from_world, -camera.rotate(camera.eye))}};
}

OrderedJson pose_json(const PinholeCamera& camera, const Pose& world_from_object) {
  return matrix_json(camera.camera_from_world * world_from_object.rotation.matrix(),
                     camera.apply(world_from_object.translation));
}

int read_pixels(const JsonPlace& place) {
  const double number = place.number(1, kMaxPictureSide);
  if (number != std::floor(number))
    place.refuse(say("whole numbers from 1 to %1", kMaxPictureSide));
  return static_cast<int>(number);
}

std::vector<LabelView> read_views(const JsonPlace& list, int width, int height) {
  std::vector<LabelView> views;
  std::set<std::string> names;
  for (const JsonPlace& place : list.items()) {
    views.push_back(read_view(place, number_text(int(views.size())), width, height));
    if (!names.insert(views.back().name).second)
      place.fail(say("\"%1\" is already the name of a camera", views.back().name));
  }
  if (views.empty()) list.refuse("at least one camera");
  return views;
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
    json["objects"].push_back(object_json(scene.objects[i], view, labels.objects[i],
                                          static_cast<int>(i) + 1, visibility));
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
