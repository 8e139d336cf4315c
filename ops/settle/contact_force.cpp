#include "ops/settle/contact_force.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivet {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr int kNewtonSteps = 12;
constexpr double kLastTurn = 1e-5;  // radians; the error after it is about its square
constexpr int kStarts = 4;          // a quarter turn apart
constexpr int kFixedPointSteps = 12;

double across(const Vec3& f) { return Vec2(f.tail<2>()).norm(); }

bool in_cone(const Vec3& f, double friction) { return across(f) <= friction * f.x(); }

// A quarter turn.
Vec2 turned(const Vec2& d) { return {-d.y(), d.x()}; }

// The direction of the force against the sliding, of length one.
class SlidingDirection {
 public:
  SlidingDirection(const LocalContact& c, const Vec3& free)
      : m_free(free.tail<2>()),
        m_coupling(c.response.block<2, 1>(1, 0)),
        m_tangential(c.response.block<2, 2>(1, 1)),
        m_normal(c.response(0, 0)),
        m_friction(c.friction),
        m_missing(c.least_speed - free.x()) {}

  // @return nothing where it does not converge to a sliding contact.
  std::optional<Vec3> force(Vec2 d) const {
    for (int i = 0; i < kNewtonSteps; ++i) {
      const double normal = normal_response(d);
      // A sliding direction in which pushing harder does not part the contact has no force.
      if (!(normal > 0)) return std::nullopt;
      const Vec2 e = turned(d);
      // Proportional to the tangential velocity, and its derivative by the direction's angle.
      const Vec2 v = normal * m_free + m_missing * (m_coupling + m_friction * (m_tangential * d));
      const Vec2 rate =
          m_friction * (m_coupling.dot(e) * m_free + m_missing * Vec2(m_tangential * e));
      // Newton's step is taken where the function grows steeply enough; elsewhere the direction
      // turns by a fixed step towards the root.
      const double off = e.dot(v), slope = e.dot(rate) - d.dot(v);
      // At the root that is sought, the velocity points against d, so that `off` grows.
      const double turn = slope > std::abs(off) ? -off / slope : off > 0 ? -1 : 1;
      d = (d + turn * e).normalized();
      if (std::abs(turn) <= kLastTurn) return d.dot(v) <= 0 ? border_force(d) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  double normal_response(const Vec2& d) const { return m_normal + m_friction * m_coupling.dot(d); }

  std::optional<Vec3> border_force(const Vec2& d) const {
    // The force on the cone's border is as large as it takes to reach the least speed.
    const double f = m_missing / normal_response(d);
    return Vec3(f, f * m_friction * d.x(), f * m_friction * d.y());
  }

  const Vec2 m_free, m_coupling;
  const Eigen::Matrix2d m_tangential;
  const double m_normal, m_friction, m_missing;
};

// The nearest point of the cone.
Vec3 projected(const Vec3& f, double friction) {
  const double length = across(f);
  // Inside the cone a force stays; inside the polar cone it vanishes; between, it lands on the
  // border.
  if (length <= friction * f.x()) return f;
  if (friction * length <= -f.x()) return Vec3::Zero();
  const double normal = (f.x() + friction * length) / (1 + friction * friction);
  const double scale = friction * normal / length;
  return {normal, scale * f.y(), scale * f.z()};
}

Vec3 fixed_point(const LocalContact& c, const Vec3& free, Vec3 force) {
  // The step is safe for every response matrix: no eigenvalue is above the trace.
  const double step = 1 / c.response.trace();
  for (int i = 0; i < kFixedPointSteps; ++i) {
    // De Saxce's change of variable turns sliding friction into a projection: the normal speed
    // grows by the sliding speed [Acary 2011].
    Vec3 velocity = free + c.response * force;
    velocity.x() += c.friction * across(velocity) - c.least_speed;
    force = projected(force - step * velocity, c.friction);
  }
  return force;
}

}  // namespace

Vec3 contact_force(const LocalContact& c, const Mat3& inverse_response, const Vec3& free,
                   const Vec3& last) {
  // A contact that parts fast enough by itself needs no force.
  if (free.x() >= c.least_speed) return Vec3::Zero();
  if (c.friction == 0) return {(c.least_speed - free.x()) / c.response(0, 0), 0, 0};
  // The force that stops all sliding is the answer if friction can give it.
  Vec3 sticking = inverse_response * (Vec3(c.least_speed, 0, 0) - free);
  if (in_cone(sticking, c.friction)) return sticking;
  // The last sweep's direction is near the root, so the search starts there; quarter turns are
  // fallbacks.
  Vec2 guess = last.tail<2>();
  if (guess == Vec2::Zero()) guess = sticking.tail<2>();
  const double length = guess.norm();
  guess = length > 0 ? Vec2(guess / length) : Vec2(Vec2::UnitX());
  const SlidingDirection sliding(c, free);
  for (int quarter = 0; quarter < kStarts; ++quarter, guess = turned(guess))
    if (const auto force = sliding.force(guess)) return *force;
  // The fixed-point steps always give a force inside the cone, if not an exact one.
  return fixed_point(c, free, last);
}

}  // namespace trivet
