#include "ops/files/arrange/model_supports.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include "core/contact/body.h"
#include "ops/arrange/settled_poses.h"
#include "ops/arrange/support_surfaces.h"
#include "ops/files/json/text.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/model_info.h"

namespace trivet {
namespace {

constexpr size_t kShownPoses = 24;  // round things have hundreds

Body standing(const Model& model, const Shape& shape) {
  return {shape, world_from_object({}, model.up, 1)};
}

// Settled pose of a likely stable pose; the shape outlives it.
std::optional<SettledPose> settled(const Model& model, const Shape& shape,
                                   const std::vector<StablePose>& poses, size_t i) {
  if (i >= kShownPoses) return std::nullopt;
  const std::shared_ptr<const Shape> shared(std::shared_ptr<const Shape>(), &shape);
  return settled_pose(shared, model.up, 1, poses[i]);
}

OrderedJson settled_json(const SettledPose& at_rest) {
  const Rotation& r = at_rest.rotation;
  return {{"rotation", {r.w, r.x, r.y, r.z}},
          {"turned_deg", at_rest.turned_deg},
          {"stays", at_rest.stays()}};
}

std::string node_name(const Model& model) {
  return std::filesystem::path(model.path).filename().string();
}

OrderedJson pose_json(const StablePose& pose) {
  const Rotation& r = pose.rotation;
  return {{"rotation", {r.w, r.x, r.y, r.z}},
          {"probability", pose.probability},
          {"margin", pose.margin},
          {"tilt_deg", pose.tilt_deg}};
}

OrderedJson point_json(const Vec2& p) { return {p.x(), p.y()}; }

OrderedJson surface_json(const SupportSurface& surface) {
  OrderedJson outline = OrderedJson::array();
  for (const Vec2& p : surface.outline) outline.push_back(point_json(p));
  const bool open = !(surface.head_room < kInfinity);
  return {{"height", surface.height},
          {"lowest", surface.lowest},
          {"highest", surface.highest},
          {"area", surface.area},
          {"lower", point_json(surface.lower)},
          {"upper", point_json(surface.upper)},
          {"head_room", open ? OrderedJson() : OrderedJson(surface.head_room)},
          {"outline", outline}};
}

void add_poses(const Model& model, const Shape& shape, OrderedJson& json) {
  const std::vector<StablePose> poses = stable_poses(shape, model.up);
  json["poses"] = OrderedJson::array();
  for (size_t i = 0; i < poses.size(); ++i) {
    json["poses"].push_back(pose_json(poses[i]));
    if (const auto at_rest = settled(model, shape, poses, i))
      json["poses"].back()["settled"] = settled_json(*at_rest);
  }
  json["upright"] = nullptr;
  const auto upright = upright_pose(poses);
  if (!upright) json["upright_reason"] = in_english(no_upright_pose(node_name(model), poses));
  for (size_t i = 0; upright && i < poses.size(); ++i)
    if (poses[i].tilt_deg == upright->tilt_deg && json["upright"].is_null()) json["upright"] = i;
}

void write_poses(const Model& model, const Shape& shape, std::ostream& out) {
  const std::vector<StablePose> poses = stable_poses(shape, model.up);
  const auto upright = upright_pose(poses);
  out << "  poses       " << poses.size()
      << " on a plane: probability, margin, tilt from the model's up, degrees to where PUT lets it "
         "rest, rotation w x y z\n";
  for (size_t i = 0; i < std::min(poses.size(), kShownPoses); ++i) {
    const StablePose& pose = poses[i];
    const Rotation& r = pose.rotation;
    out << std::fixed << "  " << std::setw(10) << i << "  " << std::setprecision(5)
        << pose.probability << "  " << std::defaultfloat << std::setprecision(4) << std::setw(9)
        << pose.margin << "  " << std::fixed << std::setprecision(2) << std::setw(6)
        << pose.tilt_deg << "  " << settled(model, shape, poses, i)->turned_deg << "  "
        << std::setprecision(6) << r.w << " " << r.x << " " << r.y << " " << r.z
        << (upright && upright->tilt_deg == pose.tilt_deg ? "  upright" : "") << "\n"
        << std::defaultfloat;
  }
  if (poses.size() > kShownPoses)
    out << "              and " << poses.size() - kShownPoses << " less likely ones: see --json\n";
  if (!upright)
    out << "  upright     " << in_english(no_upright_pose(node_name(model), poses)) << "\n";
}

void write_surfaces(const Model& model, const Shape& shape, std::ostream& out) {
  const std::vector<SupportSurface> surfaces = support_surfaces(standing(model, shape));
  out << "  surfaces    " << surfaces.size()
      << " to set things down on: height, area, rectangle seen from above, head room\n"
      << std::setprecision(6);
  for (size_t i = 0; i < surfaces.size(); ++i) {
    const SupportSurface& s = surfaces[i];
    out << "  " << std::setw(10) << i << "  " << s.height;
    if (s.highest > s.lowest) out << " (" << s.lowest << " to " << s.highest << ")";
    out << "  " << s.area << "  " << s.lower.x() << " " << s.lower.y() << " to " << s.upper.x()
        << " " << s.upper.y() << "  ";
    if (s.head_room < kInfinity)
      out << s.head_room << "\n";
    else
      out << "open above\n";
  }
}

}  // namespace

std::string model_info_json(const Model& model, const Shape& shape, const ModelSupports& asked) {
  OrderedJson json = OrderedJson::parse(model_info_json(model, shape));
  if (asked.poses) add_poses(model, shape, json);
  if (asked.surfaces) {
    json["surfaces"] = OrderedJson::array();
    for (const SupportSurface& surface : support_surfaces(standing(model, shape)))
      json["surfaces"].push_back(surface_json(surface));
  }
  return readable_json(json);
}

std::string model_info_text(const Model& model, const Shape& shape, const ModelSupports& asked) {
  std::ostringstream out;
  out << model_info_text(model, shape);
  if (asked.poses) write_poses(model, shape, out);
  if (asked.surfaces) write_surfaces(model, shape, out);
  return out.str();
}

}  // namespace trivet
