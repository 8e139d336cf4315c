// Private. Integrals over bodies and surfaces.
#pragma once

#include <Eigen/Geometry>

#include "core/base/types.h"

namespace trivet {

/// Integrals of 1, x, |x|^2 and x x^T over a body, where x is relative to an origin.
struct Moments {
  double measure = 0;
  Vec3 first = Vec3::Zero();
  double second = 0;
  Mat3 products = Mat3::Zero();

  /// Adds the simplex with these corners; if it is a tetrahedron, the origin is its apex.
  void add(double size, const Triangle& corners, int num_corners) {
    const Vec3 sum = corners[0] + corners[1] + corners[2];
    const double squares =
        corners[0].squaredNorm() + corners[1].squaredNorm() + corners[2].squaredNorm();
    measure += size;
    first += size / num_corners * sum;
    // Integrals of products over a simplex of k corners: (sum sum^T + the corners' own) / (k (k +
    // 1)).
    const double weight = size / (num_corners * (num_corners + 1));
    second += weight * (squares + sum.squaredNorm());
    products += weight * sum * sum.transpose();
    for (const Vec3& c : corners) products += weight * c * c.transpose();
  }

  Vec3 centre() const { return first / measure; }
  /// Mean squared distance from the centre.
  double spread() const { return second / measure - centre().squaredNorm(); }
  Mat3 covariance() const { return products / measure - centre() * centre().transpose(); }
};

inline Triangle relative_to(const Vec3& origin, const Triangle& t) {
  return {t[0] - origin, t[1] - origin, t[2] - origin};
}

inline double signed_volume(const Triangle& t) { return t[0].cross(t[1]).dot(t[2]) / 6; }
inline double area_of(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }

}  // namespace trivet
