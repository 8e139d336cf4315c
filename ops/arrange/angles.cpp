#include "ops/arrange/angles.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/motion/motion.h"

namespace trivet {

double twice_arctangent_deg(double s, double c) {
  return s <= c ? turned_deg(s / c) : 180 - turned_deg(c / s);
}

double angle_between_deg(const Vec3& a, const Vec3& b) {
  // tan(angle / 2) = |a x b| / (|a| |b| + a . b); for obtuse angles its reciprocal, which does not
  // cancel.
  const double cosine = a.dot(b), lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  const double sine = a.cross(b).norm();
  return cosine >= 0 ? twice_arctangent_deg(sine, lengths + cosine)
                     : twice_arctangent_deg(lengths - cosine, sine);
}

double angle_between_deg(const Vec2& a, const Vec2& b) {
  return angle_between_deg(Vec3(a.x(), a.y(), 0), Vec3(b.x(), b.y(), 0));
}

Rotation turned_about_z(double angle_deg) {
  // Whole quarters are exact, so that a thing turned by 90 degrees stays axis-aligned.
  const double quarters = std::floor(angle_deg / 90 + 0.5);
  const double s = turn_time(angle_deg - 90 * quarters);
  const Rotation rest{1, 0, 0, s};
  const Rotation by_quarters[] = {{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, -1}};
  const auto index = static_cast<int>(quarters - 4 * std::floor(quarters / 4));
  return (by_quarters[index] * rest).normalized();
}

Rotation smallest_rotation(const Vec3& from, const Vec3& to) {
  // Half of the turn's angle has this cosine and sine, but for their common length.
  const double cosine = from.dot(to);
  const Vec3 axis = from.cross(to);
  if (1 + cosine > 1e-12) return Rotation{1 + cosine, axis.x(), axis.y(), axis.z()}.normalized();
  // Opposite directions have no shortest way round: any axis across them will do.
  const Vec3 other = std::abs(from.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 across = (other - other.dot(from) * from).normalized();
  return Rotation{0, across.x(), across.y(), across.z()}.normalized();
}

}  // namespace trivet
