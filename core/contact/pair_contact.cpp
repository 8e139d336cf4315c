#include "core/contact/pair_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "core/contact/decide.h"
#include "core/contact/rounding.h"
#include "core/contact/triangle_distance.h"
#include "core/motion/height.h"

// a, b: corners of the moving and of the fixed triangle, relative to a point on the axis.
// n: normal of a plane, from the fixed to the moving side. u, v: edges.

namespace trivet {
namespace {

struct State {
  Triangle a, b;
  const Motion& motion;

  bool turning() const { return motion.kind == Motion::Kind::Rotation; }
};

double lowest(const Triangle& t, const Vec3& n) {
  return std::min({n.dot(t[0]), n.dot(t[1]), n.dot(t[2])});
}

double highest(const Triangle& t, const Vec3& n) {
  return std::max({n.dot(t[0]), n.dot(t[1]), n.dot(t[2])});
}

// A plane that stands still, with unit normal n.
double until_static_plane(const State& s, const Vec3& n, double target) {
  // The fixed triangle stays below the plane, so the moving corner that comes down first decides.
  const double level = highest(s.b, n) + target;
  double first = kInfinity;
  for (const Vec3& p : s.a) {
    const double f0 = n.dot(p) - level;
    if (f0 <= 0) return 0;
    const HeightFunction f = height_of_moving_point(f0, n, p, s.motion);
    first = std::min(first, first_zero(f, s.motion.kind));
  }
  return first;
}

// A plane that turns with the moving triangle, with unit normal n at the start.
double until_moving_plane(const State& s, const Vec3& n, double target) {
  // Seen from the moving plane, the fixed corners rise; the first that reaches it decides.
  const double level = lowest(s.a, n) - target;
  double first = kInfinity;
  for (const Vec3& q : s.b) {
    const double f0 = level - n.dot(q);
    if (f0 <= 0) return 0;
    const HeightFunction f = height_over_moving_plane(f0, -n, q, s.motion);
    first = std::min(first, first_zero(f, s.motion.kind));
  }
  return first;
}

// The scale of an edge-edge normal N = u x v that may be relied on, and until when |N| stays below
// it: |N| = |u| |v| sin(angle), and the angle changes no faster than the turn.
struct NormalScale {
  double scale, valid_until;
};

NormalScale normal_scale(const State& s, const Vec3& u, const Vec3& v, double length_n,
                         double distance, double target) {
  // A translation keeps the edges, and with them the length of their normal.
  if (!s.turning()) return {length_n, kInfinity};
  const double largest = u.norm() * v.norm(), sine = length_n / largest;
  // The larger the factor, the longer the scale holds, but the more of the target is asked for;
  // half the distance left is a fair share.
  const double factor = std::max(1.05, 0.5 * distance / target);
  if (factor * sine >= 1) return {largest, kInfinity};
  return {factor * length_n, 0.5 * (factor - 1) * sine};
}

// The plane spanned by edge i of a and edge j of b, as both are now.
double until_edge_plane(const State& s, const ClosestPoints& closest, double target) {
  const int i = closest.a, j = closest.b;
  const Vec3 u = s.a[(i + 1) % 3] - s.a[i], v = s.b[(j + 1) % 3] - s.b[j];
  Vec3 n = u.cross(v);
  const double squared = n.squaredNorm();
  // Parallel edges span no plane.
  if (squared <= kParallelSquaredSine * u.squaredNorm() * v.squaredNorm()) return 0;
  // The normal points from the fixed edge to the moving one.
  const double sign = n.dot(closest.point_a - closest.point_b) < 0 ? -1 : 1;
  const NormalScale scale = normal_scale(s, u, v, std::sqrt(squared), closest.distance, target);
  n *= sign;
  double first = scale.valid_until;
  for (const Vec3& p : {s.a[i], s.a[(i + 2) % 3]})
    for (const Vec3& q : {s.b[j], s.b[(j + 2) % 3]}) {
      // N . (p - q) with N = R u x v: v . R (p x u) - (v x q) . R u
      const double f0 = n.dot(p - q) - target * scale.scale;
      if (f0 <= 0) return 0;
      HeightFunction f{f0, 0, n.dot(s.motion.axis)};
      if (s.turning()) {
        const HeightFunction x = turning_product(0, s.motion.axis, v, p.cross(u));
        const HeightFunction y = turning_product(0, s.motion.axis, v.cross(q), u);
        f = {f0, sign * (x.A - y.A), sign * (x.B - y.B)};
      }
      first = std::min(first, first_zero(f, s.motion.kind));
    }
  return first;
}

// Unit normal of t on the side of `towards`; zero for a triangle without inside.
Vec3 face_normal(const Triangle& t, const Vec3& towards) {
  const Vec3 e = t[1] - t[0], f = t[2] - t[0];
  const Vec3 n = e.cross(f);
  const double squared = n.squaredNorm();
  const double longest = std::max(e.squaredNorm(), f.squaredNorm());
  if (squared <= kFlat * longest * longest) return Vec3::Zero();
  return (n.dot(towards) < 0 ? -1.0 : 1.0) / std::sqrt(squared) * n;
}

double until_face_planes(const State& s, const Vec3& towards_a, double target) {
  double first = 0;
  // The plane of the fixed face stands still; that of the moving face turns with it.
  const Vec3 nb = face_normal(s.b, towards_a), na = face_normal(s.a, towards_a);
  if (nb != Vec3::Zero()) first = std::max(first, until_static_plane(s, nb, target));
  if (na == Vec3::Zero()) return first;
  return std::max(
      first, s.turning() ? until_moving_plane(s, na, target) : until_static_plane(s, na, target));
}

// The direction between the closest points, which at tiny distances is mostly rounding: made
// perpendicular again to the closest edges that it is nearly perpendicular to.
Vec3 plane_direction(const State& s, const ClosestPoints& closest) {
  constexpr double kNearlyPerpendicular = 1e-5;
  Vec3 n = (closest.point_a - closest.point_b) / closest.distance;
  const int i = closest.a, j = closest.b;
  for (const Vec3& edge : {Vec3(s.a[(i + 1) % 3] - s.a[i]), Vec3(s.b[(j + 1) % 3] - s.b[j])}) {
    const double squared = edge.squaredNorm(), along = edge.dot(n);
    // A nearly perpendicular direction was meant to be perpendicular, and differs by rounding.
    if (along * along < kNearlyPerpendicular * kNearlyPerpendicular * squared)
      n -= along / squared * edge;
  }
  return n.normalized();
}

// Time until which the best of the planes keeps the triangles apart.
double until_best_plane(const State& s, const ClosestPoints& closest, double target) {
  const Vec3 towards_a = closest.point_a - closest.point_b;
  const Vec3 n = plane_direction(s, closest);
  double first = until_static_plane(s, n, target);
  if (s.turning()) first = std::max(first, until_moving_plane(s, n, target));
  if (closest.features == ClosestPoints::Features::EdgeEdge)
    first = std::max(first, until_edge_plane(s, closest, target));
  // No other plane can do better.
  if (first == kInfinity) return first;
  return std::max(first, until_face_planes(s, towards_a, target));
}

// A plane that stands still, or that moves along.
double until_plane(const State& s, const Vec3& n, double target) {
  const double first = until_static_plane(s, n, target);
  return s.turning() ? std::max(first, until_moving_plane(s, n, target)) : first;
}

// The same of `n` and of its neighbours, each made perpendicular to an edge.
double until_plane_along_edges(const State& s, const std::array<Vec3, 6>& edges, const Vec3& n,
                               double target) {
  double first = until_plane(s, n, target);
  for (const Vec3& edge : edges) {
    const double squared = edge.squaredNorm();
    if (squared == 0) continue;
    const Vec3 across = n - n.dot(edge) / squared * edge;
    const double length = across.norm();
    if (length > 0) first = std::max(first, until_plane(s, across / length, target));
  }
  return first;
}

// For a pair that the planes before do not separate, because rounding tilts them: where the
// triangles are nearer than about 4e-8 of their size, the direction between their closest points
// is not known well enough, nor is the normal of a needle. Tries the directions that two edges
// span.
double until_any_plane(const State& s, const ClosestPoints& closest, double target) {
  const Vec3 towards_a = (closest.point_a - closest.point_b) / closest.distance;
  const std::array<Vec3, 6> edges{s.a[1] - s.a[0], s.a[2] - s.a[1], s.a[0] - s.a[2],
                                  s.b[1] - s.b[0], s.b[2] - s.b[1], s.b[0] - s.b[2]};
  // The direction between the closest points is tried first, then all fifteen normals that two of
  // the six edges span.
  double first = until_plane_along_edges(s, edges, towards_a, target);
  for (size_t i = 0; i < edges.size(); ++i)
    for (size_t j = i + 1; j < edges.size(); ++j) {
      const Vec3 n = edges[i].cross(edges[j]);
      const double length = n.norm();
      // Parallel edges, or those of length zero, span no direction.
      if (length <= 1e-16 * edges[i].norm() * edges[j].norm()) continue;
      // All normals point from b towards a, as bounds expect it.
      const Vec3 unit = (n.dot(towards_a) < 0 ? -1 : 1) / length * n;
      first = std::max(first, until_plane_along_edges(s, edges, unit, target));
    }
  return first;
}

bool clear_of_static_plane(const State& s, const Vec3& n, double target, double horizon) {
  // No root is taken: most pairs need only the answer whether anything happens before the horizon.
  const double level = highest(s.b, n) + target;
  for (const Vec3& p : s.a)
    if (!positive_until(height_of_moving_point(n.dot(p) - level, n, p, s.motion), s.motion.kind,
                        horizon))
      return false;
  return true;
}

bool clear_of_moving_plane(const State& s, const Vec3& n, double target, double horizon) {
  const double level = lowest(s.a, n) - target;
  for (const Vec3& q : s.b)
    if (!positive_until(height_over_moving_plane(level - n.dot(q), -n, q, s.motion), s.motion.kind,
                        horizon))
      return false;
  return true;
}

// Proves cheaply, by the planes of the two faces, that the pair is free up to `horizon`.
// @return until when the plane found proves it; 0: neither does.
DecidedPair free_by_faces(const State& s, double largest_stop, double horizon) {
  // The mean of the corners tells the side, without the closest points, which cost more.
  const Vec3 towards_a = (s.a[0] - s.b[0]) + (s.a[1] - s.b[1]) + (s.a[2] - s.b[2]);
  const Vec3 nb = face_normal(s.b, towards_a);
  if (nb != Vec3::Zero() && clear_of_static_plane(s, nb, largest_stop, horizon))
    return {{}, std::max(horizon, until_static_plane(s, nb, largest_stop)), nb};
  const Vec3 na = face_normal(s.a, towards_a);
  if (na == Vec3::Zero()) return {{}, 0};
  // Along a translation a face's plane keeps its normal, so one test does for either face.
  if (!s.turning() && clear_of_static_plane(s, na, largest_stop, horizon))
    return {{}, std::max(horizon, until_static_plane(s, na, largest_stop)), na};
  if (s.turning() && clear_of_moving_plane(s, na, largest_stop, horizon))
    return {{}, std::max(horizon, until_moving_plane(s, na, largest_stop)), na};
  return {{}, 0};
}

double later(const State& s, double time, double step) {
  return s.turning() ? compose_turns(time, step) : time + step;
}

double extent(const State& s) {
  double out = 0;
  for (int k = 0; k < 3; ++k)
    out = std::max({out, s.a[k].cwiseAbs().maxCoeff(), s.b[k].cwiseAbs().maxCoeff()});
  return out;
}

Triangle at_time(const Triangle& t, const Motion& motion, double time) {
  return {moved_point(t[0], motion, time), moved_point(t[1], motion, time),
          moved_point(t[2], motion, time)};
}

DecidedPair at_contact(PairContact::Status status, double time, const ClosestPoints& closest,
                       const Vec3& centre, const Vec3& normal) {
  DecidedPair decided{{}, time, normal};
  PairContact& out = decided.contact;
  out.status = status;
  out.time = time;
  out.point = closest.point_b + centre;
  out.gap = closest.distance;
  if (closest.distance > 0) out.normal = (closest.point_a - closest.point_b) / closest.distance;
  return decided;
}

}  // namespace

double Clearance::target(double initial) const {
  return initial <= kHysteresis * distance ? kRestingShrink * initial : distance;
}

double Clearance::largest_stop() const { return (1 + 1.1 * kTargetSlack) * distance; }

PairContact first_contact(const Triangle& moving, const Triangle& fixed, const Motion& motion,
                          const Clearance& clearance, double best) {
  return decide_pair(moving, fixed, motion, clearance, best).contact;
}

DecidedPair decide_pair(const Triangle& moving, const Triangle& fixed, const Motion& motion,
                        const Clearance& clearance, double best) {
  // Relative to the axis (or to the fixed triangle): no digits are lost far from the origin.
  const bool turning = motion.kind == Motion::Kind::Rotation;
  const Vec3 centre = turning ? motion.centre : fixed[0];
  Motion local = motion;
  local.centre = Vec3::Zero();
  Triangle start;
  State s{{}, {}, local};
  for (int k = 0; k < 3; ++k) start[k] = moving[k] - centre, s.b[k] = fixed[k] - centre;
  s.a = start;
  // A contact later than the best one known does not matter, so the search ends there.
  const double horizon = std::min(best, motion.limit);
  // Most pairs are proved free by the plane of one of the faces.
  const DecidedPair clear = free_by_faces(s, clearance.largest_stop(), horizon);
  if (clear.apart_until > 0) return clear;

  double time = 0, target = 0;
  Vec3 normal = Vec3::Zero();  // at the start
  // Conservative advancement: a plane between the closest points keeps the pair apart until it is
  // reached; the next plane starts there.
  for (int planes = 0; planes < kMaxSeparatingPlanes; ++planes) {
    const ClosestPoints closest = closest_points(s.a, s.b);
    if (planes == 0) {
      // They cross already, as far as doubles can tell.
      if (closest.distance <= kRounding * extent(s))
        return at_contact(PairContact::Status::Crossing, 0, closest, centre, normal);
      target = clearance.target(closest.distance);
      normal = plane_direction(s, closest);
    }
    // They are as near as they may come.
    if (closest.distance <= (1 + kTargetSlack) * target)
      return at_contact(PairContact::Status::Contact, time, closest, centre, normal);
    // Turns compose; translations add.
    double next = later(s, time, until_best_plane(s, closest, target));
    // Planes tilted by rounding make no progress: every direction is tried before the pair counts
    // as stalled.
    if (next <= time) next = later(s, time, until_any_plane(s, closest, target));
    if (next > horizon) return {{}, next, normal};
    if (next <= time)
      return at_contact(PairContact::Status::Stalled, time, closest, centre, normal);
    time = next;
    s.a = at_time(start, local, time);
  }
  return at_contact(PairContact::Status::Stalled, time, closest_points(s.a, s.b), centre, normal);
}

double apart_by_plane(std::span<const Triangle> moving, std::span<const Triangle> fixed,
                      const Vec3& n, const Motion& motion, double largest_stop, double horizon) {
  // Relative to the axis, or to the fixed faces, as in decide_pair().
  const bool turning = motion.kind == Motion::Kind::Rotation;
  // The fixed faces' highest point along n, with the largest stop, is the level to stay above.
  const Vec3 centre = turning ? motion.centre : fixed[0][0];
  double level = -kInfinity, until = kInfinity;
  for (const Triangle& t : fixed)
    for (const Vec3& q : t) level = std::max(level, n.dot(q - centre));
  level += largest_stop;
  // Each moving corner has to stay above it until the horizon; the first that comes down ends the
  // proof.
  for (const Triangle& t : moving)
    for (const Vec3& p : t) {
      const Vec3 x = p - centre;
      const HeightFunction f = height_of_moving_point(n.dot(x) - level, n, x, motion);
      if (!positive_until(f, motion.kind, horizon)) return 0;
      until = std::min(until, first_zero(f, motion.kind));
    }
  return std::max(horizon, until);
}

double first_floor_contact(const Vec3& p, const Motion& motion, const Clearance& clearance) {
  // The target shrinks for a vertex that rests already, so that it can turn over its contact.
  const double f0 = p.z() - clearance.target(p.z());
  return first_zero(height_of_moving_point(f0, Vec3::UnitZ(), p - motion.centre, motion),
                    motion.kind);
}

}  // namespace trivet
