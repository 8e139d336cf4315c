#include "core/contact/first_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/contact/approach.h"
#include "core/contact/decide.h"
#include "core/contact/leaf_box.h"
#include "core/contact/slab_motion.h"

namespace trivet {
namespace {

bool turning_box_clear_until(const Approach& x, double horizon) {
  constexpr auto kTurn = Motion::Kind::Rotation;
  return positive_until(grown_box(x), kTurn, horizon) ||
         positive_until(sphere_of_box(x), kTurn, horizon);
}

// One moving against one fixed body, in the frame of the fixed body (unit scale, its boxes are
// axis-aligned there).
class PairTraversal {
 public:
  PairTraversal(const FirstContactQuery& query, Index moving, Index fixed, FirstContact& best)
      : m_query(query),
        m_moving(moving),
        m_fixed(fixed),
        m_best(best),
        m_frame(query.fixed[fixed]),
        m_a(m_frame.tree(query.moving[moving])),
        m_b(m_frame.own_tree(query.fixed[fixed])),
        m_motion(query.motion),
        m_axis(m_frame.direction(query.motion.axis)),
        m_centre(m_frame.point(query.motion.centre)),
        m_own_axis{m_a.own_axis(0), m_a.own_axis(1), m_a.own_axis(2)} {
    for (int k = 0; k < 3; ++k) {
      m_own_axis_abs[k] = m_own_axis[k].cwiseAbs();
      m_own_axis_speed[k] = m_own_axis[k].dot(m_axis);
    }
    m_motion.axis = m_axis;
    m_motion.centre = Vec3::Zero();
    m_rotation = m_a.linear / m_a.scale;
    const double spread = m_a.translation.cwiseAbs().maxCoeff() + m_centre.cwiseAbs().maxCoeff();
    m_margin = query.clearance.largest_stop() * 1.002 + 1e-14 * spread;
    m_slabs = {m_motion, m_margin};
    m_slabs.motion.centre = m_centre;
  }

  double root_bound() const { return bound(m_a.box(0), m_b.box(0)); }
  void run() { visit(0, 0, m_a.box(0), m_b.box(0), nullptr); }

 private:
  // Before this time the two boxes are farther apart than any pair stops; infinity: always.
  double bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
    return m_query.motion.kind == Motion::Kind::Translation ? translation_bound(a, b)
                                                            : rotation_bound(a, b);
  }

  double translation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
    double enter = 0, leave = kInfinity;
    for (int k = 0; k < 3; ++k) {
      const double reach = a.half[k] + b.half[k] + m_margin;
      const double offset = a.centre[k] - b.centre[k], speed = m_axis[k];
      if (speed == 0) {
        if (std::abs(offset) > reach) return kInfinity;
        continue;
      }
      const double t0 = (-reach - offset) / speed, t1 = (reach - offset) / speed;
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    return enter <= leave ? enter : kInfinity;
  }

  double rotation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
    const Vec3 r = a.centre - m_centre;
    const double height = m_axis.dot(r);
    const Vec3 radial = r - height * m_axis, tangent = m_axis.cross(r);
    if (misses_ring(a, b, height, radial)) return kInfinity;
    double until = 0;
    for (int k = 0; k < 3; ++k) {
      const double offset = a.centre[k] - b.centre[k], sign = offset < 0 ? -1 : 1;
      const Approach approach{std::abs(offset) - a.half[k] - b.half[k] - m_margin,
                              a.half[k],
                              a.radius,
                              {0, sign * radial[k], sign * tangent[k]}};
      until = std::max(until, box_until(approach, Motion::Kind::Rotation));
      if (hopeless(until)) break;
    }
    return until;
  }

  // The same along the moving body's own axes, which turn with it: its boxes are tight there. Of a
  // rotation only whether they keep the boxes apart for as long as it matters: no roots needed.
  double own_axes_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
    const bool turning = m_motion.kind == Motion::Kind::Rotation;
    const Vec3 q = b.centre - m_centre, d = b.centre - a.centre;
    double until = 0;
    for (int k = 0; k < 3; ++k) {
      const double offset = m_own_axis[k].dot(d), sign = offset < 0 ? -1 : 1;
      const double extent = m_own_axis_abs[k].dot(b.half);
      const double gap = std::abs(offset) - a.own_half[k] - extent - m_margin;
      if (gap <= 0) continue;
      if (!turning) {
        until = std::max(until, first_zero({gap, 0, -sign * m_own_axis_speed[k]}, m_motion.kind));
        continue;
      }
      const HeightFunction centre = height_over_moving_plane(0, sign * m_own_axis[k], q, m_motion);
      if (turning_box_clear_until({gap, extent, b.radius, centre}, horizon())) return kInfinity;
    }
    return until;
  }

  // The ring that the moving box's sphere sweeps about the axis: heights and radii are kept.
  bool misses_ring(const PlacedBvh::Box& a, const PlacedBvh::Box& b, double height,
                   const Vec3& radial) const {
    const Vec3 q = b.centre - m_centre;
    const double height_b = m_axis.dot(q), reach = a.radius + b.radius + m_margin;
    if (std::abs(height - height_b) > reach) return true;
    return std::abs(radial.norm() - (q - height_b * m_axis).norm()) > reach;
  }

  // The same for the leaf of one body and a box of the other, from the leaf's tight box.
  bool leaf_clear(const LeafBox& leaf, bool leaf_moves, const PlacedBvh::Box& box) const {
    for (int k = 0; k < 3; ++k) {
      const auto [gap, side] = leaf.outside(k, box);
      const Vec3 n = side * leaf.axis[k], x = box.centre - m_centre;
      const HeightFunction f = leaf_moves ? height_over_moving_plane(gap - m_margin, n, x, m_motion)
                                          : height_of_moving_point(gap - m_margin, n, x, m_motion);
      if (positive_until(f, m_motion.kind, horizon())) return true;
    }
    return false;
  }

  // Later contacts do not matter.
  double horizon() const { return std::min(m_best.time, m_query.motion.limit); }
  bool hopeless(double bound) const { return bound > horizon(); }

  struct Next {
    double bound;
    double gap;  // of the boxes' spheres, at time 0
    Index a, b;
    PlacedBvh::Box box_a, box_b;

    bool before(const Next& other) const {
      return std::tie(bound, gap) < std::tie(other.bound, other.gap);
    }
  };

  // The bound of a pair of nodes; `leaf` is the tight box of the one that is a leaf already.
  Next next(Index a, Index b, const PlacedBvh::Box& box_a, const PlacedBvh::Box& box_b, bool open_a,
            const LeafBox* leaf) const {
    ++m_best.work.node_pairs;
    double until = bound(box_a, box_b);
    if (!hopeless(until)) until = std::max(until, own_axes_bound(box_a, box_b));
    if (!hopeless(until))
      until = m_slabs.clear_until({m_a, a, m_rotation}, {m_b, b, Mat3::Identity()}, box_a, box_b,
                                  until, horizon());
    if (leaf && !hopeless(until) && leaf_clear(*leaf, !open_a, open_a ? box_a : box_b))
      until = kInfinity;
    return {until, (box_a.centre - box_b.centre).norm() - box_a.radius - box_b.radius, a, b, box_a,
            box_b};
  }

  void visit(Index ia, Index ib, const PlacedBvh::Box& box_a, const PlacedBvh::Box& box_b,
             const LeafBox* leaf) {
    const BvhNode &a = m_a.bvh.nodes[ia], &b = m_b.bvh.nodes[ib];
    if (a.is_leaf() && b.is_leaf()) return try_leaves(a, b);
    std::optional<LeafBox> own;
    if (!leaf && (a.is_leaf() || b.is_leaf())) {
      own.emplace(a.is_leaf() ? LeafBox(m_query.moving[m_moving], a, m_frame)
                              : LeafBox(m_query.fixed[m_fixed], b, m_frame));
      leaf = &*own;
    }
    const LeafBox* usable = leaf && leaf->valid ? leaf : nullptr;
    const bool open_a = !a.is_leaf() && (b.is_leaf() || box_a.radius > box_b.radius);
    const Index first = open_a ? ia + 1 : ib + 1, second = open_a ? a.second_child : b.second_child;
    Next x = open_a ? next(first, ib, m_a.box(first), box_b, true, usable)
                    : next(ia, first, box_a, m_b.box(first), false, usable);
    Next y = open_a ? next(second, ib, m_a.box(second), box_b, true, usable)
                    : next(ia, second, box_a, m_b.box(second), false, usable);
    if (y.before(x)) std::swap(x, y);
    for (const Next* n : {&x, &y})
      if (!hopeless(n->bound)) visit(n->a, n->b, n->box_a, n->box_b, leaf);
  }

  void try_leaves(const BvhNode& a, const BvhNode& b) {
    std::array<Triangle, kMaxLeafFaces> fixed;
    for (Index j = 0; j < b.num_faces; ++j)
      fixed[j] = m_query.fixed[m_fixed].triangle(m_b.bvh.faces[b.second_child + j]);
    for (Index i = 0; i < a.num_faces; ++i) {
      const Index face_a = m_a.bvh.faces[a.second_child + i];
      const Triangle ta = m_query.moving[m_moving].triangle(face_a);
      for (Index j = 0; j < b.num_faces; ++j)
        decide_faces(m_query, m_moving, m_fixed, face_a, m_b.bvh.faces[b.second_child + j], ta,
                     fixed[j], m_best);
    }
  }

  const FirstContactQuery& m_query;
  Index m_moving, m_fixed;
  FirstContact& m_best;
  UnitFrame m_frame;
  PlacedBvh m_a, m_b;
  Motion m_motion;  // in this frame, about the origin
  Vec3 m_axis, m_centre;
  Mat3 m_rotation;                                 // of the moving body
  std::array<Vec3, 3> m_own_axis, m_own_axis_abs;  // of the moving body
  std::array<double, 3> m_own_axis_speed;          // of a translation, along them
  double m_margin;
  SlabMotion m_slabs;
};

}  // namespace

FirstContact first_contact(const FirstContactQuery& query) {
  // box_until() holds for a quarter turn at most.
  assert(query.motion.kind == Motion::Kind::Translation || query.motion.limit <= 1);
  FirstContact best;
  struct Candidate {
    double bound;
    Index moving, fixed;
  };
  std::vector<Candidate> candidates;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m) {
    if (!query.moving[m].shape->has_faces()) continue;
    if (query.floor) decide_floor(query, m, best);
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f) {
      if (!query.fixed[f].shape->has_faces()) continue;
      const double bound = PairTraversal(query, m, f, best).root_bound();
      if (bound <= query.motion.limit) candidates.push_back({bound, m, f});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.bound, a.moving, a.fixed) < std::tie(b.bound, b.moving, b.fixed);
  });
  for (const Candidate& c : candidates)
    if (c.bound <= best.time) PairTraversal(query, c.moving, c.fixed, best).run();
  return best;
}

FirstContact first_contact_brute_force(const FirstContactQuery& query) {
  FirstContact best;
  for (Index m = 0; m < static_cast<Index>(query.moving.size()); ++m) {
    const Mesh& mesh = query.moving[m].shape->mesh;
    if (query.floor)
      for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v)
        decide_floor_vertex(query, m, v, best);
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
      for (Index i = 0; i < static_cast<Index>(mesh.triangles.size()); ++i)
        for (Index j = 0; j < static_cast<Index>(query.fixed[f].shape->mesh.triangles.size()); ++j)
          decide_faces(query, m, f, i, j, query.moving[m].triangle(i), query.fixed[f].triangle(j),
                       best);
  }
  return best;
}

}  // namespace trivet
