// A face in the world, prepared for being tried with others for contact. Private.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/base/types.h"

namespace trivet {

/// Height over length below which a face has no normal.
inline constexpr double kFlatFace = 1e-9;

/// The parts of a face that need no square root: enough for most pairs.
struct PlainFace {
  Triangle corners;
  std::array<Vec3, 3> edge;  // from each corner to the next
  Vec3 area_normal;          // of twice the area's length

  explicit PlainFace(const Triangle& t)
      : corners(t),
        edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]},
        area_normal(edge[0].cross(edge[1])) {}

  double longest_squared() const {
    return std::max({edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm()});
  }
  /// The least and the largest height of t over the plane, in lengths of n.
  std::pair<double, double> heights(const Triangle& t, const Vec3& n) const {
    const double h[3] = {n.dot(t[0] - corners[0]), n.dot(t[1] - corners[0]),
                         n.dot(t[2] - corners[0])};
    return {std::min({h[0], h[1], h[2]}), std::max({h[0], h[1], h[2]})};
  }
  /// True if t is on one side of the plane and farther than `distance`: only if
  /// ContactFace::separates() says so, too.
  bool clearly_separates(const Triangle& t, double distance) const {
    const double squared = area_normal.squaredNorm(), longest = longest_squared();
    if (squared <= 1.001 * kFlatFace * kFlatFace * longest * longest) return false;
    const auto [low, high] = heights(t, area_normal);
    const double nearest = low > 0 ? low : high < 0 ? -high : 0;
    return nearest * nearest > 1.001 * distance * distance * squared;
  }
};

/// With its unit normal, and the boxes of its edges.
struct ContactFace : PlainFace {
  std::array<Aabb, 3> edge_box;
  Vec3 normal = Vec3::Zero();  // unit; zero unless valid
  bool valid = false;          // it has a normal

  explicit ContactFace(const PlainFace& face) : PlainFace(face) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = corners[k], &q = corners[(k + 1) % 3];
      edge_box[k] = {p.cwiseMin(q), p.cwiseMax(q)};
    }
    const double area = area_normal.norm();
    valid = area > kFlatFace * longest_squared();
    if (valid) normal = area_normal / area;
  }

  bool separates(const Triangle& t, double distance) const {
    if (!valid) return false;
    const auto [low, high] = heights(t, normal);
    return low > distance || high < -distance;
  }

  /// True if the foot of p on the plane is inside the face, or outside by `slack` at most.
  bool is_below(const Vec3& p, double slack) const {
    for (int k = 0; k < 3; ++k) {
      const Vec3 outward = edge[k].cross(normal);
      const double beyond = outward.dot(p - corners[k]);
      const double squared = outward.squaredNorm();
      if (beyond <= 0) continue;
      if (beyond * beyond > 1.001 * slack * slack * squared) return false;
      if (outward.normalized().dot(p - corners[k]) > slack) return false;
    }
    return true;
  }
};

}  // namespace trivet
