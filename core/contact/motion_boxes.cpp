// Two faces that stop each other at time t have points p (moving) and q (fixed) that are at most
// largest_stop() apart then. The box of p's face holds the coordinates of p at all times up to t,
// that of q's face those of all points as near to q: so the boxes overlap.
#include "core/contact/motion_boxes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/contact/leaf_faces.h"

namespace trivet {
namespace {

constexpr double kSlack = 1e-12;        // relative, for rounding
constexpr double kSpreadSlack = 4e-14;  // of coordinates, relative to the largest
constexpr double kFlat = 1e-14;         // area over the squared distance of the farthest corner

Vec2 left_of(const Vec2& p) { return {-p.y(), p.x()}; }

// Increases with the angle of p from 0 to 4 in a whole turn, whatever the length of p.
double angle_measure(const Vec2& p) {
  const double sum = std::abs(p.x()) + std::abs(p.y());
  const double y = p.y() / sum;
  return p.x() >= 0 ? (y >= 0 ? y : 4 + y) : 2 - y;
}

// The point of the segment nearest to the origin.
Vec2 nearest_on(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = along.squaredNorm();
  if (squared == 0) return a;
  return a + std::clamp(-a.dot(along) / squared, 0.0, 1.0) * along;
}

// The same of a triangle; the origin itself if it is inside.
Vec2 nearest_on(const std::array<Vec2, 3>& t) {
  // The origin is inside if it lies on the same side of all three edges.
  const auto side = [](const Vec2& a, const Vec2& b) { return left_of(a).dot(b); };
  const double sides[] = {side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])};
  const double squared = std::max({t[0].squaredNorm(), t[1].squaredNorm(), t[2].squaredNorm()});
  const auto [lowest, highest] = std::minmax({sides[0], sides[1], sides[2]});
  // Within rounding of the longest edge the origin is found to be near it.
  if (lowest > kFlat * squared || highest < -kFlat * squared) return Vec2::Zero();
  // Outside, the nearest point is on an edge.
  Vec2 out = nearest_on(t[0], t[1]);
  for (const Vec2& p : {nearest_on(t[1], t[2]), nearest_on(t[2], t[0])})
    if (p.squaredNorm() < out.squaredNorm()) out = p;
  return out;
}

// p after a turn by the angle 2 atan(s), but for its length.
Vec2 turned(const Vec2& p, double s) { return (1 - s * s) * p + 2 * s * left_of(p); }

struct AngleRange {
  double lower, upper;
};

// Angle measures of a triangle whose points are all ahead along `nearest`, from its first point
// turned back to its last one turned on.
AngleRange angle_range(const std::array<Vec2, 3>& t, const Vec2& nearest, double s_back,
                       double s_on) {
  // All points are ahead along `nearest`, so their slopes order their angles.
  const auto slope = [&](const Vec2& p) { return left_of(nearest).dot(p) / nearest.dot(p); };
  const auto [first, last] = std::minmax_element(
      t.begin(), t.end(), [&](const Vec2& a, const Vec2& b) { return slope(a) < slope(b); });
  const double lower = angle_measure(turned(*first, -s_back)) - kSlack;
  const double upper = angle_measure(turned(*last, s_on)) + kSlack;
  // A range that passes the cut goes on beyond the period, so that lower stays below upper.
  return {lower, upper < lower ? upper + MotionBoxes::kPeriod : upper};
}

}  // namespace

MotionBoxes::MotionBoxes(const FirstContactQuery& query, double horizon)
    : m_turning(query.motion.kind == Motion::Kind::Rotation),
      m_origin(m_turning || query.moving.empty() ? query.motion.centre
                                                 : query.moving[0].world_box.centre()),
      m_horizon(std::min(horizon, query.motion.limit) * (1 + kSlack)) {
  // The third axis is the motion's: a translation grows boxes along it, a turn sweeps angles about
  // it.
  const Vec3 w = query.motion.axis, u = w.unitOrthogonal(), v = w.cross(u);
  m_local_from_world << u.transpose(), v.transpose(), w.transpose();
  double spread = m_origin.cwiseAbs().maxCoeff();
  for (const auto bodies : {query.moving, query.fixed})
    for (const Body& body : bodies) spread = std::max(spread, body.world_box.max_abs_coordinate());
  // The growth covers the largest stop and the rounding of local coordinates.
  m_growth = query.clearance.largest_stop() * 1.002 + kSpreadSlack * spread;
}

Triangle MotionBoxes::local(const Triangle& world) const {
  return {m_local_from_world * (world[0] - m_origin), m_local_from_world * (world[1] - m_origin),
          m_local_from_world * (world[2] - m_origin)};
}

Aabb MotionBoxes::moving(const Triangle& world) const {
  // A face of a turn is swept over angles; that of a translation is drawn out along the motion.
  const Triangle t = local(world);
  if (m_turning) return turning_box(t, 0, m_horizon);
  Aabb out = box_of(t);
  out.upper.z() += m_horizon;
  return out;
}

Aabb MotionBoxes::fixed(const Triangle& world) const {
  const Triangle t = local(world);
  if (m_turning) return turning_box(t, m_growth, 0);
  const Aabb box = box_of(t);
  return {box.lower.array() - m_growth, box.upper.array() + m_growth};
}

Aabb MotionBoxes::turning_box(const Triangle& t, double growth, double s_sweep) const {
  // Seen along the axis, the nearest point gives the smallest radius, and a corner the largest.
  const std::array<Vec2, 3> across{t[0].head<2>(), t[1].head<2>(), t[2].head<2>()};
  const Vec2 nearest = nearest_on(across);
  const double radius = nearest.norm();
  Aabb out{{radius - growth, kInfinity, 0}, {0, -kInfinity, kPeriod}};
  for (const Vec3& p : t) {
    out.upper.x() = std::max(out.upper.x(), p.head<2>().norm() + growth);
    out.lower.y() = std::min(out.lower.y(), p.z() - growth);
    out.upper.y() = std::max(out.upper.y(), p.z() + growth);
  }
  // Near the axis any angle is possible, and the box keeps the whole turn.
  if (radius > 2 * m_growth) {
    // tan(asin(x) / 2) < 0.6 x for x <= 1/2
    const double s_growth = 0.6 * growth / radius;
    const AngleRange angles =
        angle_range(across, nearest, s_growth, growth > 0 ? s_growth : s_sweep);
    out.lower.z() = angles.lower;
    out.upper.z() = angles.upper;
  } else if (growth == 0) {
    out.upper.z() += kPeriod;  // wherever it starts
  }
  return out;
}

}  // namespace trivet
