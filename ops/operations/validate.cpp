#include "ops/operations/validate.h"

#include <cmath>
#include <sstream>

#include "core/base/limits.h"
#include "core/scene/materials.h"
#include "ops/free_places/place_region.h"

namespace trivet {
namespace {

constexpr double kUnitTolerance = 1e-9;  // of a quaternion's squared length

template <class Values>
std::string shown(const Values& values) {
  std::ostringstream out;
  const char* separator = "[";
  for (const double value : values) out << separator << value, separator = ", ";
  out << "]";
  return out.str();
}

Sentence numbers(long count, double most) {
  return say("%1 numbers from %2 to %3", count, figure(-most), figure(most));
}

/// Collects the first complaint.
class Checker {
 public:
  void range(const char* key, double value, double lower, double upper) {
    if (value >= lower && value <= upper) return;
    complain(key, in_english(figure(value)),
             say("a number from %1 to %2", figure(lower), figure(upper)));
  }

  template <class Vec>
  void vector(const char* key, const Vec& v) {
    if ((v.array().abs() <= kMaxLength).all()) return;
    complain(key, shown(v), numbers(v.size(), kMaxLength));
  }

  template <class Vec>
  void direction(const char* key, const Vec& v) {
    if (!(v.array().abs() <= kMaxDirectionComponent).all()) {
      complain(key, shown(v), numbers(v.size(), kMaxDirectionComponent));
    } else if (v.cwiseAbs().maxCoeff() < kMinDirectionComponent) {
      complain(key, shown(v), "a direction whose length is not zero");
    }
  }

  void region(const char* key, const std::vector<Vec2>& corners) {
    for (const Vec2& corner : corners) vector(key, corner);
    if (!is_convex_region(corners))
      complain(key, std::to_string(corners.size()) + " corners", kConvexRegion);
  }

  void rotation(const char* key, const Rotation& q) {
    const double squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (std::abs(squared - 1) <= kUnitTolerance) return;
    complain(key, shown(std::array{q.w, q.x, q.y, q.z}), "a quaternion [w, x, y, z] of length 1");
  }

  void pose(const Pose& pose) {
    vector("position", pose.translation);
    rotation("rotation", pose.rotation);
  }

  void material(const PhysicsMaterial& m) {
    range("friction", m.friction, kMinFriction, kMaxFriction);
    range("density", m.density, kMinDensity, kMaxDensity);
    range("restitution", m.restitution, 0, kMaxRestitution);
    if (!m.name.empty() && !is_preset(m))
      complain("material", "\"" + m.name + "\"", "no name, or a preset's with its numbers");
  }

  void complain(const char* key, std::string value, Sentence accepted) {
    if (!m_found) m_found = InvalidArgument{key, std::move(value), std::move(accepted)};
  }

  std::optional<InvalidArgument> take() { return std::move(m_found); }

 private:
  std::optional<InvalidArgument> m_found;
};

void check(const PutOperation& o, Checker& checker) {
  checker.range("tries", o.tries, 1, o.place ? 1 : kMaxTriesOfPut);
  checker.range("within", o.within, 0, kMaxWithin);
  if (!o.place) return checker.pose(o.start);
  checker.rotation("rotation", o.start.rotation);
  if (o.place->near) checker.vector("at", *o.place->near);
  checker.range("seed", static_cast<double>(o.place->seed), 0, static_cast<double>(kMaxSeed));
  checker.range("keep", o.place->keep, 0, kMaxLength);
  checker.range("least_margin", o.place->least_margin, 0, kMaxLength);
  if (o.place->most_friction < kInfinity)
    checker.range("most_friction", o.place->most_friction, kMinFriction, kMaxFriction);
  if (!o.place->region.empty()) checker.region("region", o.place->region);
  if (o.place->from) checker.range("from", *o.place->from, -kMaxLength, kMaxLength);
}

void check(const PushOperation& o, Checker& checker) {
  if (o.to) {
    checker.vector("to", *o.to);
    for (const Vec2& waypoint : o.via) checker.vector("via", waypoint);
  } else {
    checker.direction("direction", o.direction);
    checker.range("distance", o.distance, 0, kMaxLength);
  }
  checker.direction("normal", o.normal);
  checker.range("step_up", o.step_up, 0, kMaxLength);
  checker.range("step_down", o.step_down, 0, kMaxLength);
}

void check(const TurnOperation& o, Checker& checker) {
  if (o.point) checker.vector("point", *o.point);
  if (o.centre) checker.vector("centre", *o.centre);
  if (o.axis) checker.direction("axis", *o.axis);
  checker.range("angle_deg", o.angle_deg, -kMaxAngleDeg, kMaxAngleDeg);
}

void check(const PickUpOperation& o, Checker& checker) {
  checker.range("distance", o.distance, 0, kMaxLength);
}

void check(const TranslateOperation& o, Checker& checker) {
  checker.vector("by", o.by);
  for (const Vec3& waypoint : o.via) checker.vector("via", waypoint);
}

void check(const RotateOperation& o, Checker& checker) {
  checker.direction("axis", o.axis);
  checker.range("angle_deg", o.angle_deg, -kMaxAngleDeg, kMaxAngleDeg);
  if (o.centre) checker.vector("centre", *o.centre);
}

void check(const AppendOperation& o, Checker& checker) {
  checker.range("scale", o.scale, kMinScale, kMaxScale);
  if (o.material) checker.material(*o.material);
}

void check(const MaterialOperation& o, Checker& checker) { checker.material(o.material); }

void check(const StandOperation& o, Checker& checker) { checker.pose(o.pose); }

void check(const ArrangeOperation& o, Checker& checker) {
  if (!o.problem) checker.complain("problem", "nothing", "a problem of arranging");
}

template <class Other>
void check(const Other&, Checker&) {}

}  // namespace

std::optional<InvalidArgument> find_invalid_argument(const Operation& operation) {
  Checker checker;
  std::visit([&](const auto& o) { check(o, checker); }, operation);
  return checker.take();
}

std::optional<Refusal> validate(const Operation& operation) {
  const auto found = find_invalid_argument(operation);
  if (!found) return std::nullopt;
  Refusal why{Refusal::Cause::InvalidArgument};
  why.detail = say("%1: %2: %3 is not accepted; accepted: %4", std::string(op_name(operation)),
                   found->key, found->value, found->accepted);
  return why;
}

}  // namespace trivet
