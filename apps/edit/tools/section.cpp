#include "apps/edit/tools/section.h"

#include "apps/edit/tools/picking.h"

namespace trivet::edit {
namespace {

constexpr double kInFrontOf = 1e-3;  // of the object's size, in front of it
constexpr double kProbes = 0.6;      // of the object's half width: rays around its middle

double nearest_depth(const View& view, const Aabb& box) {
  return view.depth(box.centre()) - view.axes().back.cwiseAbs().dot(box.half_extent());
}

/// True if something stands between the viewer and the object's near side.
bool is_hidden(const SceneSnapshot& scene, const View& view, const Aabb& box, double near_side,
               const std::vector<ObjectId>& except) {
  const View::Axes axes = view.axes();
  const Vec3 half = kProbes * box.half_extent();
  const Vec3 right = axes.right.cwiseAbs().dot(half) * axes.right;
  const Vec3 up = axes.up.cwiseAbs().dot(half) * axes.up;
  for (const Vec3& aside : {Vec3(Vec3::Zero()), right, Vec3(-right), up, Vec3(-up)}) {
    const auto px = view.project(box.centre() + aside);
    if (!px) continue;
    const auto seen = pick(scene, view.ray(*px), except);
    if (seen && seen->object && view.depth(seen->point) < near_side) return true;
  }
  return false;
}

}  // namespace

std::optional<double> section_depth(const SceneSnapshot& scene, const Selection& selection,
                                    const View& view, const Section& section,
                                    const std::vector<ObjectId>& except) {
  if (!section.on) return std::nullopt;
  const auto id = selection.active();
  const ObjectSnapshot* const object = id ? scene.find(*id) : nullptr;
  if (!object || !(*object)->placed) {
    const Aabb all = scene.box();
    if (section.only_if_hidden || all.empty()) return std::nullopt;
    return view.depth(all.centre()) + section.shift;
  }
  std::vector<ObjectId> moving = with_loads(scene, *id);
  Aabb box;
  for (const ObjectId member : moving) box.extend(world_box(*scene.find(member)->object));
  const double near_side = nearest_depth(view, box) - kInFrontOf * box.diagonal();
  moving.insert(moving.end(), except.begin(), except.end());
  const bool automatic = section.only_if_hidden && section.shift == 0;
  if (automatic && !is_hidden(scene, view, box, near_side, moving)) return std::nullopt;
  return near_side + section.shift;
}

}  // namespace trivet::edit
