#include "core/contact/pair_traversal.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "core/contact/approach.h"

namespace trivet {
namespace {

// No point of the face goes farther until the time t than t times this: of a turn the chord.
double speed_of(const Triangle& moving, const Motion& motion) {
  if (motion.kind == Motion::Kind::Translation) return 1;
  // A point's chord grows no faster with s than twice its distance from the axis.
  double squared = 0;
  for (const Vec3& p : moving)
    squared = std::max(squared, motion.axis.cross(p - motion.centre).squaredNorm());
  return 2 * std::sqrt(squared);
}

// Largest distance at which anything stops, for all rounding of coordinates up to `spread`.
double margin(const FirstContactQuery& query, double spread) {
  return query.clearance.largest_stop() * 1.002 + 1e-14 * spread;
}

// The second child of a node is elsewhere in memory.
void prefetch(const Bvh& bvh, Index node) {
  __builtin_prefetch(&bvh.nodes[node]);
  __builtin_prefetch(&bvh.slabs[node]);
}

}  // namespace

LeafInMotion::LeafInMotion(const Body& body, const BvhNode& leaf, const Motion& motion)
    : LeafFaces(body, leaf) {
  for (size_t i = 0; i < num; ++i) {
    boxes[i] = box_of(corners[i]);
    speeds[i] = speed_of(corners[i], motion);
  }
}

PairMotions::PairMotions(const PairFrames& frames, const Motion& motion)
    : of_moving(motion), of_fixed(motion) {
  // Directions are rewritten in the fixed body's frame; the fixed body moves the other way as seen
  // from the moving one.
  const Mat3 moving_from_fixed = frames.fixed_from_moving.transpose();
  of_moving.axis = frames.fixed.direction(motion.axis);
  of_moving.centre = frames.fixed.point(motion.centre);
  of_fixed.axis = -(moving_from_fixed * of_moving.axis);
  of_fixed.centre = moving_from_fixed * of_moving.centre;
}

PairTraversal::PairTraversal(const FirstContactQuery& query, Index moving, Index fixed,
                             TraversalMemory& memory, SeparatingPlanes& planes, FirstContact& best)
    : m_query(query),
      m_part(query),
      m_moving(moving),
      m_fixed(fixed),
      m_memory(memory),
      m_planes(planes),
      m_best(best),
      m_frames(query.moving[moving], query.fixed[fixed]),
      m_motions(m_frames, query.motion),
      m_margin(margin(query, m_frames.origin_of_moving.cwiseAbs().maxCoeff() +
                                 m_motions.of_moving.centre.cwiseAbs().maxCoeff())),
      m_world_margin(margin(query, std::max(query.moving[moving].world_box.max_abs_coordinate(),
                                            query.fixed[fixed].world_box.max_abs_coordinate()) +
                                       query.motion.centre.cwiseAbs().maxCoeff())),
      m_a(m_frames.moving_nodes(query.moving[moving], m_motions.of_moving)),
      m_b(m_frames.fixed_nodes(query.fixed[fixed], m_motions.of_fixed)),
      m_nodes(m_motions.of_moving, m_motions.of_fixed, m_margin),
      m_apart_until(m_nodes.apart_until({m_a, 0}, {m_b, 0}, query.motion.limit)) {
  if (m_apart_until <= query.motion.limit) m_waiting.push_back({m_apart_until, 0, 0, false});
}

void PairTraversal::search(double until) {
  // Decisions are made for this part of the motion only; pairs proved apart until its end wait for
  // the next one.
  m_part.motion.limit = until;
  std::swap(m_waiting, m_woken);
  m_waiting.clear();
  // Pairs are woken in the order in which they were put off, so that results repeat to the bit.
  for (const Waiting& pair : m_woken) resume(pair);
}

void PairTraversal::wait(const Waiting& pair) {
  // A pair is kept only if a later part may still need it.
  const bool is_last = m_part.motion.limit >= m_query.motion.limit;
  if (!is_last && pair.bound <= std::min(m_best.time, m_query.motion.limit))
    m_waiting.push_back(pair);
}

void PairTraversal::resume(const Waiting& pair) {
  if (hopeless(pair.bound)) return wait(pair);
  // The pair waited with a bound that this part of the motion has reached.
  if (pair.are_leaves) return try_leaves(pair.a, pair.b);
  const Next n = next(pair.a, pair.b);
  if (hopeless(n.bound)) return wait({n.bound, n.a, n.b, false});
  visit(n.a, n.b);
}

// The bound of a pair of nodes.
PairTraversal::Next PairTraversal::next(Index a, Index b) {
  ++m_best.work.node_pairs;
  const double until = m_nodes.apart_until(node_a(a), node_b(b), horizon());
  return {hopeless(until) ? until : std::max(until, apart_by_last_plane(a, b)), a, b};
}

// Boxes of long faces that lie askew are far larger than these. At the plane that separated faces
// last, the corners of such a leaf are held against the other body's nodes.
// @return as NodeMotion::apart_until().
double PairTraversal::apart_by_last_plane(Index ia, Index ib) {
  const bool leaf_a = m_a.bvh().nodes[ia].is_leaf(), leaf_b = m_b.bvh().nodes[ib].is_leaf();
  // Faces of two leaves are asked together later.
  if (!m_plane.is_known() || leaf_a == leaf_b) return 0;
  const PlacedNode &a = node_a(ia), &b = node_b(ib);
  const double lowest = (leaf_a ? faces_a(ia).along(m_plane.world, m_frames.fixed.origin)
                                : along(a, kMoving, m_plane))
                            .first;
  const double highest =
      (leaf_b ? faces_b(ib).along(m_plane.world, m_frames.fixed.origin) : along(b, kFixed, m_plane))
          .second;
  const Vec3& n = m_plane.in_fixed;
  Approach approach{lowest - highest - m_world_margin,
                    n.dot(a.centre_in(kFixed)) - lowest,
                    a.radius,
                    {0, 0, n.dot(m_motions.of_moving.axis)}};
  if (m_query.motion.kind == Motion::Kind::Rotation)
    approach.centre = {0, n.dot(a.radial), n.dot(a.tangent)};
  const double until = box_until(approach, m_query.motion.kind);
  return hopeless(until) ? until : 0;
}

// The boxes' spheres are so far apart, at time 0.
double PairTraversal::gap(const Next& pair) {
  const PlacedNode &a = node_a(pair.a), &b = node_b(pair.b);
  return (a.centre_in(kFixed) - b.centre_in(kFixed)).norm() - a.radius - b.radius;
}

// The one that may touch first goes first; of equals the nearer one. What it finds bounds the
// other.
bool PairTraversal::goes_first(const Next& x, const Next& y) {
  if (x.bound != y.bound) return x.bound < y.bound;
  return !hopeless(x.bound) && gap(x) < gap(y);
}

void PairTraversal::visit(Index ia, Index ib) {
  const BvhNode &a = m_a.bvh().nodes[ia], &b = m_b.bvh().nodes[ib];
  if (a.is_leaf() && b.is_leaf()) return try_leaves(ia, ib);
  // The larger node is opened.
  const bool open_a = !a.is_leaf() && (b.is_leaf() || node_a(ia).radius > node_b(ib).radius);
  open_a ? prefetch(m_a.bvh(), a.second_child) : prefetch(m_b.bvh(), b.second_child);
  Next x = open_a ? next(ia + 1, ib) : next(ia, ib + 1);
  Next y = open_a ? next(a.second_child, ib) : next(ia, b.second_child);
  if (goes_first(y, x)) std::swap(x, y);
  for (const Next& n : {x, y})
    if (hopeless(n.bound))
      wait({n.bound, n.a, n.b, false});
    else
      visit(n.a, n.b);
}

// The cheapest proof: most faces of two leaves are farther apart than they come nearer.
double PairTraversal::faces_apart_until(const Aabb& moving, const Aabb& fixed, double speed) const {
  // The distance of two boxes is no larger than that of their faces.
  const Vec3 beside =
      (moving.lower - fixed.upper).cwiseMax(fixed.lower - moving.upper).cwiseMax(0.0);
  const double gap = beside.norm() - m_world_margin;
  return gap > 0 ? gap / speed * (1 - 1e-12) : 0;
}

void PairTraversal::try_leaves(Index ia, Index ib) {
  const LeafInMotion &a = faces_a(ia), &b = faces_b(ib);
  // The plane that separated the last faces often separates these leaves as a whole.
  if (m_plane.is_known())
    if (const double until = apart_by_plane(a.all(), b.all(), m_plane.world, m_query.motion,
                                            m_query.clearance.largest_stop(), horizon());
        until > 0)
      return wait({until, ia, ib, true});
  // Otherwise every pair of their faces is decided.
  double apart_until = kInfinity;
  for (size_t i = 0; i < a.num; ++i)
    for (size_t j = 0; j < b.num; ++j) {
      double until = faces_apart_until(a.boxes[i], b.boxes[j], a.speeds[i]);
      if (!hopeless(until)) until = decide(a, i, b, j);
      apart_until = std::min(apart_until, until);
    }
  wait({apart_until, ia, ib, true});
}

// @return time until which they are apart. The plane between them may separate others, too, and the
// same faces in the next motion.
double PairTraversal::decide(const LeafFaces& a, size_t i, const LeafFaces& b, size_t j) {
  // The plane of an earlier motion is tried before a new one is looked for.
  if (const Vec3* n = m_planes.find(a.face[i], b.face[j]))
    if (const double until =
            apart_by_plane({&a.corners[i], 1}, {&b.corners[j], 1}, *n, m_query.motion,
                           m_query.clearance.largest_stop(), horizon());
        until > 0)
      return until;
  const DecidedPair found = decide_faces(m_part, m_moving, m_fixed, a.face[i], b.face[j],
                                         a.corners[i], b.corners[j], m_best);
  // The normal is kept for this pair only where its plane proved the faces apart until the horizon.
  if (found.normal == Vec3::Zero()) return found.apart_until;
  m_plane = PlaneNormal(found.normal, m_frames);
  if (hopeless(found.apart_until)) m_planes.remember(a.face[i], b.face[j], found.normal);
  return found.apart_until;
}

}  // namespace trivet
