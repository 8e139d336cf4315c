#include "core/motion/motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {

Vec3 moved_point(const Vec3& p, const Motion& motion, double time) {
  if (motion.kind == Motion::Kind::Translation) return p + time * motion.axis;
  // Rodrigues' formula; the displacement is added, so that a small turn is exact to its last bits.
  const Vec3 r = p - motion.centre;
  const Vec3 tangent = motion.axis.cross(r);
  // As s = tan(angle / 2), w is the sine of the angle, and w s is one less its cosine.
  const double w = 2 * time / (1 + time * time);
  return p + w * tangent + w * time * motion.axis.cross(tangent);
}

Pose moved_pose(const Pose& pose, const Motion& motion, double time) {
  Pose out = pose;
  out.translation = moved_point(pose.translation, motion, time);
  if (motion.kind == Motion::Kind::Rotation)
    out.rotation = (Rotation::about_axis(motion.axis, time) * pose.rotation).normalized();
  return out;
}

double compose_turns(double s_first, double s_second) {
  const double denominator = 1 - s_first * s_second;
  // Together they reach half a turn or more: no motion goes as far.
  return denominator > 0 ? (s_first + s_second) / denominator : kInfinity;
}

double turn_time(double angle_deg) {
  // A quarter turn is exact, so that box-shaped things stay axis-aligned.
  if (std::abs(angle_deg) == 90) return angle_deg > 0 ? 1 : -1;
  // Half of the angle, in radians, is at most pi / 4 for the turns that motions make.
  const double x = angle_deg * (3.14159265358979323846 / 360);
  // Taylor series of sine and cosine for |x| <= pi / 4: the first omitted term is below 1e-19.
  double sine = 0, cosine = 0;
  for (int k = 16; k >= 2; k -= 2) {
    sine = -(1 + sine) * x * x / (k * (k + 1));
    cosine = -(1 + cosine) * x * x / (k * (k - 1));
  }
  return x * (1 + sine) / (1 + cosine);
}

double turned_deg(double time) {
  double angle = 90 * time;  // Newton's method; it doubles the digits each time
  for (int i = 0; i < 6; ++i) {
    const double s = turn_time(angle);
    angle += (time - s) / (1 + s * s) * (360 / 3.14159265358979323846);
  }
  return angle;
}

}  // namespace trivet
