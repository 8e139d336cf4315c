// Separating axes of the boxes of two placed shapes. Rounding is accounted for: separated boxes
// hold no two faces that touch.
#pragma once

#include <array>

#include "core/base/types.h"
#include "core/index/bvh.h"

namespace trivet {

/// Frame of the boxes of a shape in the world.
struct BoxFrame {
  Affine world_from_object;
  Vec3 reach;        // largest magnitude of each coordinate of any box, object frame
  double slack = 0;  // metres; contents of a box may be this far outside of it in the world
};

/// Separating axis test of two boxes [Gottschalk 1996] with the six face normals but without
/// the nine pairs of edges [van den Bergen 1997]. Departs from both in that linear parts may be any
/// matrices: projections of boxes are the same formula for all directions.
class SeparatingAxes {
 public:
  static constexpr int kMaxAxes = 6;

  /// Normals of the faces of both boxes; a rank-deficient linear part may have fewer.
  SeparatingAxes(const BoxFrame& a, const BoxFrame& b);

  /// Axes for a segment instead of boxes of a: `a` maps (-1, 0, 0) and (1, 0, 0) to its ends.
  static SeparatingAxes of_segment(const BoxFrame& a, const BoxFrame& b);

  /// True only if the contents of the two boxes are disjoint.
  bool separate(const Aabb& box_a, const Aabb& box_b) const;

  /// A box along all axes, for those who ask for the same one again: it depends on the linear part
  /// of its frame alone, and on that of the other.
  struct AlongAxes {
    std::array<double, kMaxAxes> centre, reach;
  };
  AlongAxes of_a(const Aabb& box) const;
  AlongAxes of_b(const Aabb& box) const;
  /// As of their boxes, to the bit.
  bool separate(const AlongAxes& a, const AlongAxes& b) const;

  /// True if the box of a is the larger one in the world.
  bool a_is_larger(const Aabb& box_a, const Aabb& box_b) const;

 private:
  /// Coordinate along a direction n of the world: of_a . x + const for x in the frame of a.
  struct Axis {
    Vec3 of_a, of_b;
    double offset;  // n . (translation of b - translation of a)
    double margin;
  };

  SeparatingAxes() = default;
  void set_frames(const BoxFrame& a, const BoxFrame& b);
  void add(const Vec3& direction, const BoxFrame& a, const BoxFrame& b);
  void add_face_normals(const Mat3& linear, const BoxFrame& a, const BoxFrame& b);

  std::array<Axis, kMaxAxes> m_axes;
  int m_num_axes = 0;
  double m_scale_a = 1, m_scale_b = 1;  // metres per unit of the object frame, at most
};

/// Calls visit(leaf of a, leaf of b) -> bool for all leaves that are not separated, until it
/// returns false.
/// @param apart  apart(node of a, node of b): as axes.separate() of their boxes.
template <class Apart, class Visit>
void visit_near_leaves(const Bvh& a, const Bvh& b, const SeparatingAxes& axes, const Apart& apart,
                       const Visit& visit) {
  if (a.nodes.empty() || b.nodes.empty()) return;
  // A stack of its own replaces recursion, as trees may be deep.
  std::vector<std::array<Index, 2>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const BvhNode &x = a.nodes[i], &y = b.nodes[j];
    // Pairs of separated boxes end here, and most of the work with them.
    if (apart(i, j)) continue;
    // The larger of two nodes that are not apart is opened, so that both get small together.
    if (x.is_leaf() && y.is_leaf()) {
      if (!visit(x, y)) return;
    } else if (y.is_leaf() || (!x.is_leaf() && axes.a_is_larger(x.box(), y.box()))) {
      stack.push_back({x.second_child, j});
      stack.push_back({i + 1, j});
    } else {
      stack.push_back({i, y.second_child});
      stack.push_back({i, j + 1});
    }
  }
}

template <class Visit>
void visit_near_leaves(const Bvh& a, const Bvh& b, const SeparatingAxes& axes, const Visit& visit) {
  const auto apart = [&](Index i, Index j) {
    return axes.separate(a.nodes[i].box(), b.nodes[j].box());
  };
  visit_near_leaves(a, b, axes, apart, visit);
}

}  // namespace trivet
