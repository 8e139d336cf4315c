#include "apps/mcp/views.h"

#include <array>

namespace trivet::mcp {
namespace {

struct NamedView {
  const char* name;
  std::array<double, 3> from;
};
// One who stands in front looks along +y, as at an object's front.
constexpr NamedView kViews[] = {
    {"corner", {0.55, -1, 0.75}}, {"above", {0, -0.02, 1}}, {"front", {0, -1, 0.15}},
    {"back", {0, 1, 0.15}},       {"left", {-1, 0, 0.15}},  {"right", {1, 0, 0.15}},
};
constexpr double kFovDeg = 30;
constexpr double kDistance = 2.1;  // of the box's diagonal: it fills the field of view

}  // namespace

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const NamedView& view : kViews) out.emplace_back(view.name);
    return out;
  }();
  return names;
}

std::optional<Camera> camera_of(const Scene& scene, const std::string& name,
                                std::optional<ObjectId> of) {
  if (name == kViews[0].name && !of) return std::nullopt;
  const Aabb box = of ? scene.world_box(*of) : scene.box();
  if (box.empty()) return std::nullopt;
  for (const NamedView& view : kViews) {
    if (name != view.name) continue;
    const Vec3 way = Vec3(view.from[0], view.from[1], view.from[2]).normalized();
    Camera out;
    out.target = box.centre();
    out.eye = out.target + way * (kDistance * box.diagonal());
    out.fov_deg = kFovDeg;
    return out;
  }
  return std::nullopt;
}

}  // namespace trivet::mcp
