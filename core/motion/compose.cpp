#include "core/motion/compose.h"

#include <cmath>

#include "core/motion/motion.h"

namespace trivet {

Pose composed(const Pose& a, const Pose& b) {
  return {a.rotation * b.rotation, a.translation + a.rotation.matrix() * b.translation};
}

Pose inverse(const Pose& pose) {
  const Rotation& r = pose.rotation;
  const Rotation back{r.w, -r.x, -r.y, -r.z};
  return {back, -(back.matrix() * pose.translation)};
}

Rotation turn_about(const Vec3& axis, double degrees) {
  // Quarter turns are exact, so that axes stay axes.
  const double angle = std::fmod(degrees, 720.0);  // a quaternion's period; exact
  const double quarters = std::round(angle / 90);
  const double h = std::sqrt(0.5);
  const double cosines[] = {1, h, 0, -h, -1, -h, 0, h};
  const int k = (static_cast<int>(quarters) + 8) % 8;
  const double c = cosines[k], s = cosines[(k + 6) % 8];
  const Rotation quarter{c, s * axis.x(), s * axis.y(), s * axis.z()};
  const double rest = angle - 90 * quarters;
  return rest == 0 ? quarter : quarter * Rotation::about_axis(axis, turn_time(rest));
}

bool is_same_pose(const Pose& a, const Pose& b) {
  const Rotation &r = a.rotation, &s = b.rotation;
  return a.translation == b.translation && r.w == s.w && r.x == s.x && r.y == s.y && r.z == s.z;
}

}  // namespace trivet
