#include "apps/edit/tools/constraint_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ops/operations/turn_axis.h"

namespace trivet::edit {
namespace {

constexpr double kFrame = 2;        // of what the object takes: half of the window
constexpr double kSmallest = 1e-3;  // least extent of the frame, metres
constexpr double kAlongZ = 0.9;

// Towards the viewer, unit.
Vec3 direction(const ObjectContact* entry, const Selection& selection,
               const std::optional<Vec3>& axis) {
  if (axis && axis->norm() > 0) return axis->normalized();
  if (!entry) return Vec3::UnitZ();
  const bool edge = selection.contact && selection.contact->part == ActiveContact::Part::Edge;
  if (edge && entry->contact.hull.size() > 1) {
    const auto [a, b] = held_line(entry->contact, selection.contact->near);
    const Vec3 along = (b - a).normalized();
    // Seen from the usual side: front, right, above.
    const double side = along.dot(Vec3(0.1, -1, 0.3));
    return side < 0 ? Vec3(-along) : along;
  }
  return entry->contact.normal;
}

}  // namespace

View constraint_view(const SceneSnapshot& scene, const Selection& selection,
                     const std::optional<Vec3>& axis, int width_px, int height_px) {
  const auto id = selection.active();
  const ObjectSnapshot* const object = id ? scene.find(*id) : nullptr;
  const bool placed = object && (*object)->placed;
  Aabb box = placed ? world_box(*object->object) : scene.box();
  if (box.empty()) box = {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
  const ObjectContact* const entry = placed ? active_object_contact(selection, scene) : nullptr;
  const Vec3 back = direction(entry, selection, axis);
  const double frame = placed ? kFrame : 1.1;
  Aabb everything = scene.box();
  everything.extend(box);
  View view;
  view.orthographic = true;
  view.target = box.centre();
  view.eye = view.target + (everything.diagonal() + frame * box.diagonal()) * back;
  view.up = std::abs(back.z()) > kAlongZ ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
  view.width_px = std::max(width_px, 1);
  view.height_px = std::max(height_px, 1);
  const View::Axes axes = view.axes();
  const auto extent = [&](const Vec3& way) { return 2 * way.cwiseAbs().dot(box.half_extent()); };
  const double across = extent(axes.right) * view.height_px / view.width_px;
  view.height = frame * std::max({kSmallest, extent(axes.up), across});
  return view;
}

}  // namespace trivet::edit
