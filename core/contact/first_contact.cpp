#include "core/contact/first_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/contact/leaf_box.h"

namespace trivet {
namespace {

bool earlier(const FirstContact& a, const FirstContact& b) {
  return std::tie(a.time, a.moving, a.fixed, a.face_moving, a.face_fixed) <
         std::tie(b.time, b.moving, b.fixed, b.face_moving, b.face_fixed);
}

void keep_earlier(const FirstContact& found, FirstContact& best) {
  if (best.status == FirstContact::Status::Free || earlier(found, best)) {
    const QueryWork work = best.work;
    best = found;
    best.work = work;
  }
}

void try_faces(const FirstContactQuery& query, Index moving, Index fixed, Index face_moving,
               Index face_fixed, const Triangle& a, const Triangle& b, FirstContact& best) {
  ++best.work.face_pairs;
  const PairContact pair = first_contact(a, b, query.motion, query.clearance, best.time);
  if (pair.status == PairContact::Status::Free) return;
  FirstContact found;
  found.status = pair.status == PairContact::Status::Crossing ? FirstContact::Status::Crossing
                                                              : FirstContact::Status::Contact;
  found.stalled = pair.status == PairContact::Status::Stalled;
  found.time = pair.time;
  found.moving = moving;
  found.fixed = fixed;
  found.face_moving = face_moving;
  found.face_fixed = face_fixed;
  found.point = pair.point;
  found.normal = pair.normal;
  found.gap = pair.gap;
  keep_earlier(found, best);
}

void try_floor_vertex(const FirstContactQuery& query, Index moving, Index vertex,
                      FirstContact& best) {
  ++best.work.face_pairs;
  const Body& body = query.moving[moving];
  const Vec3 p = body.vertex(vertex);
  const double time = first_floor_contact(p, query.motion, query.clearance);
  if (time > query.motion.limit || time > best.time) return;
  FirstContact found;
  found.status = p.z() <= 0 ? FirstContact::Status::Crossing : FirstContact::Status::Contact;
  found.time = time;
  found.moving = moving;
  found.fixed = FirstContact::kFloor;
  found.face_moving = vertex;
  const Vec3 at = moved_point(p, query.motion, time);
  found.point = Vec3(at.x(), at.y(), 0);
  found.gap = std::max(0.0, at.z());
  keep_earlier(found, best);
}

// How a box of the moving body comes nearer to something fixed, along one axis.
struct Approach {
  double gap;             // between the boxes along the axis, less the largest stop
  double extent;          // of the moving box along the axis, to one side
  double radius;          // of its sphere
  HeightFunction centre;  // A and B of its centre; f0 is not used
};

// A turning box stays within two bounds: its sphere, and itself grown by the chord 2 sin(angle / 2)
// times the radius; for s <= 1 that chord is at most 2 s + 0.8285 s^2, over 1 + s^2.
double box_until(const Approach& x, Motion::Kind kind) {
  if (x.gap <= 0) return 0;
  if (kind == Motion::Kind::Translation) return first_zero({x.gap, 0, x.centre.B}, kind);
  const double grown =
      first_zero({x.gap, x.centre.A + 0.41425 * x.radius, x.centre.B - x.radius}, kind);
  const double sphere_gap = x.gap + x.extent - x.radius;
  return sphere_gap <= 0 ? grown
                         : std::max(grown, first_zero({sphere_gap, x.centre.A, x.centre.B}, kind));
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
    for (int k = 0; k < 3; ++k) m_own_axis_abs[k] = m_own_axis[k].cwiseAbs();
    m_motion.axis = m_axis;
    m_motion.centre = Vec3::Zero();
    const double spread = m_a.translation.cwiseAbs().maxCoeff() + m_centre.cwiseAbs().maxCoeff();
    m_margin = query.clearance.largest_stop() * 1.002 + 1e-14 * spread;
  }

  double root_bound() const { return bound(m_a.box(0), m_b.box(0)); }
  void run() { visit(0, 0, m_a.box(0), m_b.box(0), nullptr); }

 private:
  // Before this time the two boxes are farther apart than any pair stops; infinity: always.
  double bound(const BoxTree::Box& a, const BoxTree::Box& b) const {
    return m_query.motion.kind == Motion::Kind::Translation ? translation_bound(a, b)
                                                            : rotation_bound(a, b);
  }

  double translation_bound(const BoxTree::Box& a, const BoxTree::Box& b) const {
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

  double rotation_bound(const BoxTree::Box& a, const BoxTree::Box& b) const {
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
    }
    return until;
  }

  // The same along the moving body's own axes, which turn with it: its boxes are tight there.
  double own_axes_bound(const BoxTree::Box& a, const BoxTree::Box& b) const {
    const Vec3 q = b.centre - m_centre, d = b.centre - a.centre;
    double until = 0;
    for (int k = 0; k < 3; ++k) {
      const double offset = m_own_axis[k].dot(d), sign = offset < 0 ? -1 : 1;
      const double extent = m_own_axis_abs[k].dot(b.half);
      const double gap = std::abs(offset) - a.own_half[k] - extent - m_margin;
      if (gap <= 0) continue;
      const Vec3 n = sign * m_own_axis[k];
      const HeightFunction centre = height_over_moving_plane(0, n, q, m_motion);
      until = std::max(until, box_until({gap, extent, b.radius, centre}, m_motion.kind));
    }
    return until;
  }

  // The ring that the moving box's sphere sweeps about the axis: heights and radii are kept.
  bool misses_ring(const BoxTree::Box& a, const BoxTree::Box& b, double height,
                   const Vec3& radial) const {
    const Vec3 q = b.centre - m_centre;
    const double height_b = m_axis.dot(q), reach = a.radius + b.radius + m_margin;
    if (std::abs(height - height_b) > reach) return true;
    return std::abs(radial.norm() - (q - height_b * m_axis).norm()) > reach;
  }

  // The same for the leaf of one body and a box of the other, from the leaf's tight box.
  double leaf_bound(const LeafBox& leaf, bool leaf_moves, const BoxTree::Box& box) const {
    double until = 0;
    for (int k = 0; k < 3; ++k) {
      const auto [gap, side] = leaf.outside(k, box);
      const Vec3 n = side * leaf.axis[k], x = box.centre - m_centre;
      const HeightFunction f = leaf_moves ? height_over_moving_plane(gap - m_margin, n, x, m_motion)
                                          : height_of_moving_point(gap - m_margin, n, x, m_motion);
      until = std::max(until, first_zero(f, m_motion.kind));
    }
    return until;
  }

  bool hopeless(double bound) const { return bound > m_best.time || bound > m_query.motion.limit; }

  struct Next {
    double bound;
    double gap;  // of the boxes' spheres, at time 0
    Index a, b;
    BoxTree::Box box_a, box_b;

    bool before(const Next& other) const {
      return std::tie(bound, gap) < std::tie(other.bound, other.gap);
    }
  };

  // The bound of a pair of nodes; `leaf` is the tight box of the one that is a leaf already.
  Next next(Index a, Index b, const BoxTree::Box& box_a, const BoxTree::Box& box_b, bool open_a,
            const LeafBox* leaf) const {
    ++m_best.work.node_pairs;
    double until = bound(box_a, box_b);
    if (!hopeless(until)) until = std::max(until, own_axes_bound(box_a, box_b));
    if (leaf && !hopeless(until))
      until = std::max(until, leaf_bound(*leaf, !open_a, open_a ? box_a : box_b));
    return {until, (box_a.centre - box_b.centre).norm() - box_a.radius - box_b.radius, a, b, box_a,
            box_b};
  }

  void visit(Index ia, Index ib, const BoxTree::Box& box_a, const BoxTree::Box& box_b,
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
    for (Index i = 0; i < a.num_faces; ++i) {
      const Index face_a = m_a.bvh.faces[a.second_child + i];
      const Triangle ta = m_query.moving[m_moving].triangle(face_a);
      for (Index j = 0; j < b.num_faces; ++j) {
        const Index face_b = m_b.bvh.faces[b.second_child + j];
        try_faces(m_query, m_moving, m_fixed, face_a, face_b, ta,
                  m_query.fixed[m_fixed].triangle(face_b), m_best);
      }
    }
  }

  const FirstContactQuery& m_query;
  Index m_moving, m_fixed;
  FirstContact& m_best;
  UnitFrame m_frame;
  BoxTree m_a, m_b;
  Motion m_motion;  // in this frame, about the origin
  Vec3 m_axis, m_centre;
  std::array<Vec3, 3> m_own_axis, m_own_axis_abs;  // of the moving body
  double m_margin;
};

// The moving body against the floor: only vertices can be first.
class FloorTraversal {
 public:
  FloorTraversal(const FirstContactQuery& query, Index moving, FirstContact& best)
      : m_query(query),
        m_moving(moving),
        m_best(best),
        m_tree(query.moving[moving]),
        m_margin(query.clearance.largest_stop() * 1.002 +
                 1e-14 * m_tree.translation.cwiseAbs().maxCoeff()) {}

  void run() { visit(0); }

 private:
  double bound(Index node) const {
    const BoxTree::Box box = m_tree.box(node);
    const Motion& motion = m_query.motion;
    const double gap = box.centre.z() - box.half.z() - m_margin;
    const HeightFunction centre =
        height_of_moving_point(0, Vec3::UnitZ(), box.centre - motion.centre, motion);
    return box_until({gap, box.half.z(), box.radius, centre}, motion.kind);
  }

  void visit(Index node) {
    const BvhNode& n = m_tree.bvh.nodes[node];
    if (n.is_leaf()) {
      for (Index i = 0; i < n.num_faces; ++i)
        for (const Index vertex :
             m_query.moving[m_moving].shape->mesh.triangles[m_tree.bvh.faces[n.second_child + i]])
          try_floor_vertex(m_query, m_moving, vertex, m_best);
      return;
    }
    m_best.work.node_pairs += 2;
    Index first = node + 1, second = n.second_child;
    double bound_first = bound(first), bound_second = bound(second);
    if (bound_second < bound_first) {
      std::swap(first, second);
      std::swap(bound_first, bound_second);
    }
    const double limit = m_query.motion.limit;
    if (bound_first <= m_best.time && bound_first <= limit) visit(first);
    if (bound_second <= m_best.time && bound_second <= limit) visit(second);
  }

  const FirstContactQuery& m_query;
  Index m_moving;
  FirstContact& m_best;
  BoxTree m_tree;
  double m_margin;
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
    if (query.moving[m].shape->bvh.nodes.empty()) continue;
    if (query.floor) FloorTraversal(query, m, best).run();
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f) {
      if (query.fixed[f].shape->bvh.nodes.empty()) continue;
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
        try_floor_vertex(query, m, v, best);
    for (Index f = 0; f < static_cast<Index>(query.fixed.size()); ++f)
      for (Index i = 0; i < static_cast<Index>(mesh.triangles.size()); ++i)
        for (Index j = 0; j < static_cast<Index>(query.fixed[f].shape->mesh.triangles.size()); ++j)
          try_faces(query, m, f, i, j, query.moving[m].triangle(i), query.fixed[f].triangle(j),
                    best);
  }
  return best;
}

}  // namespace trivet
