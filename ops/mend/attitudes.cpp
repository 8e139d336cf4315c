#include "ops/mend/attitudes.h"

#include <Eigen/Geometry>

#include "core/motion/motion.h"

namespace trivet {
namespace {

double angle_between_deg(const Vec3& a, const Vec3& b) {
  // The angle is twice the arctangent of the chord over its complement, without libm.
  const double apart = (a - b).norm(), together = (a + b).norm();
  return apart <= together ? turned_deg(apart / together) : 180 - turned_deg(together / apart);
}

// The shortest turn that takes unit `a` to unit `b`.
Rotation turn_to(const Vec3& a, const Vec3& b) {
  const Vec3 axis = a.cross(b);
  const double w = 1 + a.dot(b);
  if (w < 1e-9) return {0, 1, 0, 0};
  return Rotation{w, axis.x(), axis.y(), axis.z()}.normalized();
}

}  // namespace

std::vector<Vec3> downs_of(const Object& object, ShapeFacts& facts) {
  std::vector<Vec3> out;
  for (const StablePose& pose : facts.poses(object))
    out.push_back(pose.rotation.matrix().transpose() * -Vec3::UnitZ());
  return out;
}

std::pair<int, double> nearest_down(const std::vector<Vec3>& downs, const Rotation& rotation) {
  const Vec3 down = rotation.matrix().transpose() * -Vec3::UnitZ();
  std::pair<int, double> out{-1, 180};
  for (size_t k = 0; k < downs.size(); ++k) {
    const double angle = angle_between_deg(downs[k], down);
    if (angle < out.second) out = {static_cast<int>(k), angle};
  }
  return out;
}

Pose levelled(const Object& object, const std::vector<Vec3>& downs) {
  const Rotation& r = object.pose.rotation;
  const int k = nearest_down(downs, r).first;
  const Vec3 down = r.matrix() * downs[static_cast<size_t>(k)];
  // An attitude that is level to rounding stays to the bit.
  if (angle_between_deg(down, -Vec3::UnitZ()) < 1e-9) return object.pose;
  Pose out;
  out.rotation = (turn_to(down, -Vec3::UnitZ()) * r).normalized();
  // The middle of the box stays where it is, as a turn about the origin would move the object.
  const Vec3 middle =
      world_from_object(Pose{}, object.up, object.scale).apply(object.shape->box.centre());
  out.translation = object.pose.translation + r.matrix() * middle - out.rotation.matrix() * middle;
  return out;
}

}  // namespace trivet
