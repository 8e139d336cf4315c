#include "core/flex/closest.h"

namespace trivet::flex {
namespace {

constexpr double kParallelSegments = 1e-14;  // squared sine of an angle that counts as none

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Each corner and edge has a region whose points are nearest to it; the signs below tell the
  // region.
  const Vec3 ab = b - a, ac = c - a;
  const double ab_a = ab.dot(p - a), ac_a = ac.dot(p - a);
  if (ab_a <= 0 && ac_a <= 0) return {1, 0, 0};
  const double ab_b = ab.dot(p - b), ac_b = ac.dot(p - b);
  if (ab_b >= 0 && ac_b <= ab_b) return {0, 1, 0};
  const double beside_ab = ab_a * ac_b - ab_b * ac_a;
  if (beside_ab <= 0 && ab_a >= 0 && ab_b <= 0) {
    const double share = ab_a / (ab_a - ab_b);
    return {1 - share, share, 0};
  }
  const double ab_c = ab.dot(p - c), ac_c = ac.dot(p - c);
  if (ac_c >= 0 && ab_c <= ac_c) return {0, 0, 1};
  const double beside_ac = ab_c * ac_a - ab_a * ac_c;
  if (beside_ac <= 0 && ac_a >= 0 && ac_c <= 0) {
    const double share = ac_a / (ac_a - ac_c);
    return {1 - share, 0, share};
  }
  const double beside_bc = ab_b * ac_c - ab_c * ac_b, to_b = ac_b - ab_b, to_c = ab_c - ac_c;
  if (beside_bc <= 0 && to_b >= 0 && to_c >= 0) {
    const double share = to_b / (to_b + to_c);
    return {0, 1 - share, share};
  }
  // The foot is inside the triangle: its shares are the areas beside the edges.
  const double scale = 1 / (beside_bc + beside_ac + beside_ab);
  const double of_b = beside_ac * scale, of_c = beside_ab * scale;
  return {1 - of_b - of_c, of_b, of_c};
}

SegmentShares closest_on_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 u = p1 - p0, v = q1 - q0, r = p0 - q0;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double ur = u.dot(r), vr = v.dot(r);
  // A segment without length is a point.
  const auto unit = [](double share) { return std::clamp(share, 0.0, 1.0); };
  if (uu == 0 && vv == 0) return {};
  if (uu == 0) return {0, unit(vr / vv)};
  if (vv == 0) return {unit(-ur / uu), 0};
  // Segments that are parallel to rounding meet in the middle, so that the contact does not jump to
  // an end.
  const double determinant = uu * vv - uv * uv;
  double s = 0.5;
  if (determinant > kParallelSegments * uu * vv) s = unit((uv * vr - ur * vv) / determinant);
  // The end that clamps one share decides the other one anew.
  const double t = unit((uv * s + vr) / vv);
  s = unit((uv * t - ur) / uu);
  return {s, unit((uv * s + vr) / vv)};
}

}  // namespace trivet::flex
