#include "core/contact/pair_traversal.h"

#include <array>
#include <cmath>
#include <optional>

namespace trivet {

PairTraversal::PairTraversal(const FirstContactQuery& query, Index moving, Index fixed,
                             FirstContact& best)
    : m_query(query),
      m_part(query),
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
  const double world_spread = std::max(query.moving[moving].world_box.max_abs_coordinate(),
                                       query.fixed[fixed].world_box.max_abs_coordinate()) +
                              query.motion.centre.cwiseAbs().maxCoeff();
  m_world_margin = query.clearance.largest_stop() * 1.002 + 1e-14 * world_spread;
  m_slabs = {m_motion, m_margin};
  m_slabs.motion.centre = m_centre;
  m_apart_until = bound(m_a.box(0), m_b.box(0));
  if (m_apart_until <= query.motion.limit) m_waiting.push_back({m_apart_until, 0, 0, false});
}

void PairTraversal::search(double until) {
  m_part.motion.limit = until;
  std::swap(m_waiting, m_woken);
  m_waiting.clear();
  for (const Waiting& pair : m_woken) resume(pair);
}

void PairTraversal::wait(const Waiting& pair) {
  const bool is_last = m_part.motion.limit >= m_query.motion.limit;
  if (!is_last && pair.bound <= std::min(m_best.time, m_query.motion.limit))
    m_waiting.push_back(pair);
}

void PairTraversal::resume(const Waiting& pair) {
  if (hopeless(pair.bound)) return wait(pair);
  if (pair.are_leaves) return try_leaves(pair.a, pair.b);
  const Next n = next(pair.a, pair.b, m_a.box(pair.a), m_b.box(pair.b), true, nullptr);
  if (hopeless(n.bound)) return wait({n.apart_until, n.a, n.b, false});
  visit(n.a, n.b, n.box_a, n.box_b, nullptr);
}

// Before this time the two boxes are farther apart than any pair stops; infinity: always.
double PairTraversal::bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
  return m_query.motion.kind == Motion::Kind::Translation ? translation_bound(a, b)
                                                          : rotation_bound(a, b);
}

double PairTraversal::translation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
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

double PairTraversal::rotation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
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
double PairTraversal::own_axes_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const {
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
    if (turning_box_is_clear({gap, extent, b.radius, centre})) return kInfinity;
  }
  return until;
}

bool PairTraversal::turning_box_is_clear(const Approach& x) const {
  constexpr auto kTurn = Motion::Kind::Rotation;
  return positive_until(grown_box(x), kTurn, horizon()) ||
         positive_until(sphere_of_box(x), kTurn, horizon());
}

// The ring that the moving box's sphere sweeps about the axis: heights and radii are kept.
bool PairTraversal::misses_ring(const PlacedBvh::Box& a, const PlacedBvh::Box& b, double height,
                                const Vec3& radial) const {
  const Vec3 q = b.centre - m_centre;
  const double height_b = m_axis.dot(q), reach = a.radius + b.radius + m_margin;
  if (std::abs(height - height_b) > reach) return true;
  return std::abs(radial.norm() - (q - height_b * m_axis).norm()) > reach;
}

// The same for the leaf of one body and a box of the other, from the leaf's tight box.
bool PairTraversal::leaf_clear(const LeafBox& leaf, bool leaf_moves,
                               const PlacedBvh::Box& box) const {
  for (int k = 0; k < 3; ++k) {
    const auto [gap, side] = leaf.outside(k, box);
    const Vec3 n = side * leaf.axis[k], x = box.centre - m_centre;
    const HeightFunction f = leaf_moves ? height_over_moving_plane(gap - m_margin, n, x, m_motion)
                                        : height_of_moving_point(gap - m_margin, n, x, m_motion);
    if (positive_until(f, m_motion.kind, horizon())) return true;
  }
  return false;
}

// The bound of a pair of nodes; `leaf` is the tight box of the one that is a leaf already.
PairTraversal::Next PairTraversal::next(Index a, Index b, const PlacedBvh::Box& box_a,
                                        const PlacedBvh::Box& box_b, bool open_a,
                                        const LeafBox* leaf) const {
  ++m_best.work.node_pairs;
  const double apart_until = bound(box_a, box_b);
  double until = apart_until;
  if (!hopeless(until)) until = std::max(until, own_axes_bound(box_a, box_b));
  if (!hopeless(until))
    until = m_slabs.clear_until({m_a, a, m_rotation}, {m_b, b}, box_a, box_b, until, horizon());
  if (leaf && !hopeless(until) && leaf_clear(*leaf, !open_a, open_a ? box_a : box_b))
    until = kInfinity;
  const double gap = (box_a.centre - box_b.centre).norm() - box_a.radius - box_b.radius;
  return {until, apart_until, gap, a, b, box_a, box_b};
}

void PairTraversal::visit(Index ia, Index ib, const PlacedBvh::Box& box_a,
                          const PlacedBvh::Box& box_b, const LeafBox* leaf) {
  const BvhNode &a = m_a.bvh.nodes[ia], &b = m_b.bvh.nodes[ib];
  if (a.is_leaf() && b.is_leaf()) return try_leaves(ia, ib);
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
    if (hopeless(n->bound))
      wait({n->apart_until, n->a, n->b, false});
    else
      visit(n->a, n->b, n->box_a, n->box_b, leaf);
}

// No point of the face goes farther until the time t than t times this: of a turn the chord.
double PairTraversal::speed_of(const Triangle& moving) const {
  if (m_motion.kind == Motion::Kind::Translation) return 1;
  double squared = 0;
  for (const Vec3& p : moving)
    squared = std::max(squared, m_query.motion.axis.cross(p - m_query.motion.centre).squaredNorm());
  return 2 * std::sqrt(squared);
}

// The cheapest proof: most faces of two leaves are farther apart than they come nearer.
double PairTraversal::faces_apart_until(const Aabb& moving, const Aabb& fixed, double speed) const {
  const Vec3 beside =
      (moving.lower - fixed.upper).cwiseMax(fixed.lower - moving.upper).cwiseMax(0.0);
  const double gap = beside.norm() - m_world_margin;
  return gap > 0 ? gap / speed * (1 - 1e-12) : 0;
}

void PairTraversal::try_leaves(Index ia, Index ib) {
  const LeafFaces a(m_query.moving[m_moving], m_a.bvh.nodes[ia]);
  const LeafFaces b(m_query.fixed[m_fixed], m_b.bvh.nodes[ib]);
  if (m_plane != Vec3::Zero())
    if (const double until = apart_by_plane(a.all(), b.all(), m_plane, m_query.motion,
                                            m_query.clearance.largest_stop(), horizon());
        until > 0)
      return wait({until, ia, ib, true});
  std::array<Aabb, kMaxLeafFaces> boxes_b;
  for (size_t j = 0; j < b.num; ++j) boxes_b[j] = box_of(b.corners[j]);
  double apart_until = kInfinity;
  for (size_t i = 0; i < a.num; ++i) {
    const Aabb box_a = box_of(a.corners[i]);
    const double speed = speed_of(a.corners[i]);
    for (size_t j = 0; j < b.num; ++j) {
      double until = faces_apart_until(box_a, boxes_b[j], speed);
      if (!hopeless(until)) until = decide(a, i, b, j);
      apart_until = std::min(apart_until, until);
    }
  }
  wait({apart_until, ia, ib, true});
}

// @return time until which they are apart. The plane between them may separate others, too.
double PairTraversal::decide(const LeafFaces& a, size_t i, const LeafFaces& b, size_t j) {
  const DecidedPair found = decide_faces(m_part, m_moving, m_fixed, a.face[i], b.face[j],
                                         a.corners[i], b.corners[j], m_best);
  if (found.normal != Vec3::Zero()) m_plane = found.normal;
  return found.apart_until;
}

}  // namespace trivet
