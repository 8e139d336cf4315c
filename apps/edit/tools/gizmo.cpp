#include "apps/edit/tools/gizmo.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "apps/edit/tools/contact_picking.h"

namespace trivet::edit {
namespace {

constexpr double kLengthPx = 80, kSquarePx = 26, kRingPx = 70, kViewRingPx = 84;
constexpr double kHitPx = 7;
constexpr double kEndOn = 0.98;   // cosine between arrow and view
constexpr double kEdgeOn = 0.12;  // cosine between a square's or ring's axis and the view
constexpr int kRingParts = 48;

using Kind = GizmoHandle::Kind;

bool is_seen(const GizmoHandle& handle, const Vec3& axis, const Vec3& forward) {
  const double along = std::abs(axis.dot(forward));
  return handle.kind == Kind::Arrow ? along < kEndOn : along > kEdgeOn;
}

}  // namespace

std::vector<GizmoHandle> Gizmo::handles() const {
  if (turns) return {{Kind::Ring, 0}, {Kind::Ring, 1}, {Kind::Ring, 2}, {Kind::Ring, 3}};
  return {{Kind::Arrow, 0},  {Kind::Arrow, 1},  {Kind::Arrow, 2},
          {Kind::Square, 0}, {Kind::Square, 1}, {Kind::Square, 2}};
}

Vec3 Gizmo::axis(const GizmoHandle& handle, const View& view) const {
  return handle.axis < 3 ? Vec3(Vec3::Unit(handle.axis)) : view.axes().back;
}

std::vector<std::array<Vec3, 2>> Gizmo::lines(const GizmoHandle& handle, const View& view) const {
  const double metres = view.metres_per_px(view.depth(centre));
  const Vec3 n = axis(handle, view);
  if (handle.kind == Kind::Arrow) return {{centre, Vec3(centre + kLengthPx * metres * n)}};
  Vec3 u = handle.axis < 3 ? Vec3(Vec3::Unit((handle.axis + 1) % 3)) : view.axes().right;
  const Vec3 v = n.cross(u);
  std::vector<Vec3> way;
  if (handle.kind == Kind::Square) {
    const double a = kSquarePx * metres;
    way = {centre + a * u, centre + a * (u + v), centre + a * v};
  } else {
    const double r = metres * (handle.axis < 3 ? kRingPx : kViewRingPx);
    for (int i = 0; i <= kRingParts; ++i) {
      const double angle = 2 * std::numbers::pi * i / kRingParts;
      way.push_back(centre + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  std::vector<std::array<Vec3, 2>> out;
  for (size_t i = 0; i + 1 < way.size(); ++i) out.push_back({way[i], way[i + 1]});
  return out;
}

std::optional<GizmoHandle> Gizmo::hit(const View& view, const Vec2& px) const {
  std::optional<GizmoHandle> best;
  double nearest = kHitPx;
  const Vec3 forward = view.orthographic ? view.forward() : Vec3((centre - view.eye).normalized());
  for (const GizmoHandle& handle : handles()) {
    if (!is_seen(handle, axis(handle, view), forward)) continue;
    for (const auto& [a, b] : lines(handle, view)) {
      const auto pa = view.project(a), pb = view.project(b);
      if (!pa || !pb) continue;
      const double distance = distance_px(px, *pa, *pb);
      if (distance >= nearest) continue;
      nearest = distance;
      best = handle;
    }
  }
  return best;
}

}  // namespace trivet::edit
