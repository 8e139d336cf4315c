#include "apps/edit/document/pose_numbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/motion.h"

namespace trivet::edit {
namespace {

constexpr double kDegPerRad = 180 / std::numbers::pi;
constexpr double kUpright = 1 - 1e-12;  // sine of y above which x and z turn about one axis

}  // namespace

Vec3 angles_deg(const Rotation& rotation) {
  const Mat3 m = rotation.matrix();
  const double sine = std::clamp(-m(2, 0), -1.0, 1.0);
  const double y = kDegPerRad * std::asin(sine);
  if (std::abs(sine) > kUpright) return {0, y, kDegPerRad * std::atan2(-m(0, 1), m(1, 1))};
  return {kDegPerRad * std::atan2(m(2, 1), m(2, 2)), y, kDegPerRad * std::atan2(m(1, 0), m(0, 0))};
}

// In four parts, as one rotation turns by at most a quarter.
Rotation turned_about(const Vec3& axis, double deg) {
  const Rotation part = Rotation::about_axis(axis, turn_time(deg / 4));
  return (part * part * (part * part)).normalized();
}

Rotation rotation_by_angles(const Vec3& deg) {
  return (turned_about(Vec3::UnitZ(), deg.z()) *
          (turned_about(Vec3::UnitY(), deg.y()) * turned_about(Vec3::UnitX(), deg.x())))
      .normalized();
}

Pose with_number(Pose pose, PosePart part, int axis, double value) {
  if (part == PosePart::Position) {
    pose.translation[axis] = value;
    return pose;
  }
  Vec3 deg = angles_deg(pose.rotation);
  deg[axis] = value;
  pose.rotation = rotation_by_angles(deg);
  return pose;
}

}  // namespace trivet::edit
