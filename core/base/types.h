// Vectors, boxes, poses. World: metres, z up, right-handed. Object frame: the model file's own
// coordinates with its node transforms applied, in the file's units.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>

namespace trivet {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Triangle = std::array<Vec3, 3>;
using Index = std::int32_t;
using Index3 = std::array<Index, 3>;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Axis-aligned box; empty (lower > upper) when default-constructed.
struct Aabb {
  Vec3 lower = Vec3::Constant(kInfinity);
  Vec3 upper = Vec3::Constant(-kInfinity);

  void extend(const Vec3& p) { lower = lower.cwiseMin(p), upper = upper.cwiseMax(p); }
  void extend(const Aabb& b) { lower = lower.cwiseMin(b.lower), upper = upper.cwiseMax(b.upper); }
  bool empty() const { return !(lower.array() <= upper.array()).all(); }
  Vec3 centre() const { return 0.5 * (lower + upper); }
  Vec3 half_extent() const { return 0.5 * (upper - lower); }
  /// Length of the diagonal; 0 when empty.
  double diagonal() const { return empty() ? 0.0 : (upper - lower).norm(); }
  double max_abs_coordinate() const {
    return empty() ? 0.0 : std::max(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff());
  }
};

/// Closed overlap of two boxes grown by `margin` in total.
inline bool overlaps(const Aabb& a, const Aabb& b, double margin = 0.0) {
  return (a.lower.array() <= b.upper.array() + margin).all() &&
         (b.lower.array() <= a.upper.array() + margin).all();
}

/// x -> linear * x + translation, evaluated row by row in a fixed order, so that other programs
/// that apply the 16 numbers of a report the same way get the same bits.
struct Affine {
  Mat3 linear = Mat3::Identity();
  Vec3 translation = Vec3::Zero();

  Vec3 apply(const Vec3& p) const {
    Vec3 out;
    for (int r = 0; r < 3; ++r)
      out[r] = linear(r, 0) * p.x() + linear(r, 1) * p.y() + linear(r, 2) * p.z() + translation[r];
    return out;
  }
  Vec3 apply_direction(const Vec3& d) const {
    Vec3 out;
    for (int r = 0; r < 3; ++r)
      out[r] = linear(r, 0) * d.x() + linear(r, 1) * d.y() + linear(r, 2) * d.z();
    return out;
  }
};

}  // namespace trivet
