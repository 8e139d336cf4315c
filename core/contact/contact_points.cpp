#include "core/contact/contact_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/tunables.h"
#include "core/contact/contact_face.h"
#include "core/contact/contact_memory.h"
#include "core/contact/feature_contacts.h"
#include "core/contact/leaf_faces.h"
#include "core/contact/node_gaps.h"
#include "core/contact/opposed_parts.h"
#include "core/contact/recent_nodes.h"

namespace trivet {
namespace {

// Nodes are compared as they are: of the two bodies, the object is the one that could move.
const Motion kAtRest = Motion::translation(Vec3::Zero(), 0);
constexpr double kFar = 1.01;
constexpr Index kFewPairs = 32;  // of faces: cones are not asked

auto features_of(const ContactPoint& c) {
  return std::tie(c.features, c.feature_object, c.feature_support);
}

// A face that names a vertex or an edge twice finds its contacts twice: the order must not depend
// on which came first.
auto order_of(const ContactPoint& c) {
  return std::make_tuple(features_of(c), c.gap, c.point.x(), c.point.y(), c.point.z());
}

// Sorted, every pair of features once.
std::vector<ContactPoint> first_of_each(const std::vector<ContactPoint>& points) {
  // Pointers are sorted, as points are large.
  std::vector<const ContactPoint*> order;
  order.reserve(points.size());
  for (const ContactPoint& p : points) order.push_back(&p);
  std::sort(order.begin(), order.end(), [](const ContactPoint* a, const ContactPoint* b) {
    if (features_of(*a) != features_of(*b)) return features_of(*a) < features_of(*b);
    return std::make_tuple(order_of(*a), a) < std::make_tuple(order_of(*b), b);
  });
  std::vector<ContactPoint> out;
  for (const ContactPoint* p : order)
    if (out.empty() || features_of(out.back()) != features_of(*p)) out.push_back(*p);
  return out;
}

// Adds those of `more` that have no point of the same normal near. Compares along the widest
// extent.
void append_elsewhere(const std::vector<ContactPoint>& more, double distance,
                      std::vector<ContactPoint>& points) {
  if (more.empty()) return;
  std::vector<ContactPoint> known = points;
  Aabb box;
  // The widest axis parts the points best.
  for (const ContactPoint& p : known) box.extend(p.point);
  int along = 0;
  if (!known.empty()) box.half_extent().maxCoeff(&along);
  // Points known along the widest axis: only those within reach are compared.
  const auto before = [&](const ContactPoint& a, const ContactPoint& b) {
    return a.point[along] < b.point[along];
  };
  std::sort(known.begin(), known.end(), before);
  for (const ContactPoint& p : more) {
    // All points of which the coordinate is within reach are compared; the search starts at the
    // lowest of them.
    ContactPoint low = p;
    low.point[along] -= distance;
    bool is_new = true;
    for (auto at = std::lower_bound(known.begin(), known.end(), low, before);
         is_new && at != known.end() && at->point[along] <= p.point[along] + distance; ++at)
      is_new = !same_place(*at, p, distance);
    if (is_new) points.push_back(p);
  }
  std::sort(points.begin(), points.end(),
            [](const ContactPoint& a, const ContactPoint& b) { return order_of(a) < order_of(b); });
}

struct OwningFace : ContactFace {
  FacingFeatures::OfFace own;

  OwningFace(const PlainFace& face, const FacingFeatures::OfFace& features)
      : ContactFace(face), own(features) {}
};

/// Faces of a leaf with their boxes, world.
struct BoxedFaces : LeafFaces {
  std::array<Aabb, kMaxLeafFaces> boxes;

  BoxedFaces(const Body& body, const BvhNode& leaf) : LeafFaces(body, leaf) {
    for (size_t i = 0; i < num; ++i) boxes[i] = box_of(corners[i]);
  }
  /// Prepared when it is asked for first: most faces are too far.
  const OwningFace& prepared(const Body& body, size_t i) const {
    if (!m_prepared[i])
      m_prepared[i].emplace(PlainFace(corners[i]), own_features(*body.shape, face[i]));
    return *m_prepared[i];
  }

 private:
  mutable std::array<std::optional<OwningFace>, kMaxLeafFaces> m_prepared;
};

/// Nodes and leaves that were met last.
struct SearchMemory {
  struct OfBody {
    RecentNodes<PlacedNode, 256> nodes;
    RecentNodes<BoxedFaces, 64> faces;
  };
  OfBody object, support;
};

class ContactSearch {
 public:
  /// @param by_cones  parts that do not face each other may be left out.
  ContactSearch(const Body& object, const Body& support, double tolerance, double slack,
                bool by_cones)
      : m_object(object),
        m_support(support),
        m_tolerance(tolerance),
        m_slack(slack),
        m_may_use_cones(by_cones && OpposedParts::hold(object, support, slack)),
        m_frames(object, support),
        m_object_nodes(m_frames.moving_nodes(object, kAtRest)),
        m_support_nodes(m_frames.fixed_nodes(support, kAtRest)),
        m_reach(tolerance * 1.001 + 1e-14 * m_frames.origin_of_moving.cwiseAbs().maxCoeff()),
        m_features(object, support, tolerance, m_reach, slack) {}

  std::vector<ContactPoint> run() {
    if (!m_object.shape->has_faces() || !m_support.shape->has_faces()) return {};
    // The rounding of placed nodes grows with their distance from the origin, so the roots'
    // farthest corners bound it.
    m_node_reach = m_reach + 1e-14 * (farthest(node_a(0)) + farthest(node_b(0)));
    visit(0, 0);
    std::vector<ContactPoint> points = first_of_each(m_features.found());
    // Ends of edges and corners of flush overlaps count where nothing else does.
    append_elsewhere(m_features.ends_and_corners(), m_tolerance, points);
    if (!points.empty()) return points;
    // Without a feature that faces the other one, the closest points of near faces have to do, of
    // all of them.
    if (m_parts) return ContactSearch(m_object, m_support, m_tolerance, m_slack, false).run();
    return first_of_each(m_features.closest_points());
  }

 private:
  static double farthest(const PlacedNode& n) {
    Double2 out = both(0);
    for (int k = 0; k < 3; ++k) out = max(out, abs(n.centre[k]) + n.half[k]);
    return std::max(out[kFixed], out[kMoving]);
  }

  const PlacedNode& node_a(Index a) {
    return m_memory.object.nodes.get(m_search, a, m_object_nodes, a);
  }
  const PlacedNode& node_b(Index b) {
    return m_memory.support.nodes.get(m_search, b, m_support_nodes, b);
  }

  // Leaves are met many times; their faces and boxes stay in a small memory of the thread.
  const BoxedFaces& faces_a(Index a) {
    return m_memory.object.faces.get(m_search, a, m_object, m_object_nodes.bvh().nodes[a]);
  }
  const BoxedFaces& faces_b(Index b) {
    return m_memory.support.faces.get(m_search, b, m_support, m_support_nodes.bvh().nodes[b]);
  }

  void visit(Index ia, Index ib) {
    const PlacedNode &in_a = node_a(ia), &in_b = node_b(ib);
    if (boxes_apart(in_a, in_b, m_node_reach) || slabs_apart(in_a, in_b, m_node_reach)) return;
    // The descent splits the larger node until both are leaves.
    const BvhNode &a = m_object_nodes.bvh().nodes[ia], &b = m_support_nodes.bvh().nodes[ib];
    if (a.is_leaf() && b.is_leaf()) return try_leaves(ia, ib);
    if (m_plane.is_known() && a.is_leaf() != b.is_leaf() && leaf_is_apart(ia, ib)) return;
    if (m_parts && !m_parts->nodes_may_touch(ia, ib)) return;
    if (!a.is_leaf() && (b.is_leaf() || in_a.radius > in_b.radius)) {
      visit(ia + 1, ib);
      visit(a.second_child, ib);
    } else {
      visit(ia, ib + 1);
      visit(ia, b.second_child);
    }
  }

  void try_leaves(Index ia, Index ib) {
    const BoxedFaces &a = faces_a(ia), &b = faces_b(ib);
    if (m_plane.is_known() && are_far(along_plane(a), along_plane(b))) return;
    if (m_parts && !m_parts->nodes_may_touch(ia, ib)) return;
    for (size_t i = 0; i < a.num; ++i)
      for (size_t j = 0; j < b.num; ++j) {
        if (!overlaps(a.boxes[i], b.boxes[j], m_reach)) continue;
        FacingFeatures facing;
        if (m_parts) {
          const auto found = m_parts->facing(a.face[i], b.face[j]);
          if (!found) continue;
          facing = *found;
        }
        // The cheap test with the faces' own planes rejects most pairs whose boxes overlap.
        const OwningFace &fa = a.prepared(m_object, i), &fb = b.prepared(m_support, j);
        if (is_separated_by(fb, a.corners[i]) || is_separated_by(fa, b.corners[j])) continue;
        if (!m_parts) facing = {fa.own, fb.own};
        m_features.add(fa, a.face[i], fb, b.face[j], facing);
        ++m_num_pairs;
      }
    if (!m_parts && m_may_use_cones && cones_pay()) m_parts.emplace(m_object, m_support, m_slack);
    if (m_separating == Vec3::Zero()) return;
    m_plane = PlaneNormal(m_separating.normalized(), m_frames);
    m_separating.setZero();
  }

  // Cones are made when the search has taken about as long as that.
  bool cones_pay() const {
    Index least = kFewPairs;
    for (const Body* body : {&m_object, &m_support})
      if (!has_normal_cones(*body->shape))
        least += static_cast<Index>(body->shape->mesh.triangles.size());
    return m_num_pairs > least;
  }

  // The plane of a face separates faces beside it, too.
  bool is_separated_by(const PlainFace& face, const Triangle& t) {
    if (!face.clearly_separates(t, m_tolerance)) return false;
    m_separating = face.area_normal;
    return true;
  }

  std::pair<double, double> along_plane(const LeafFaces& faces) const {
    return faces.along(m_plane.world, m_frames.fixed.origin);
  }

  // All points of both are too far from each other along the last plane's normal.
  bool are_far(const std::pair<double, double>& a, const std::pair<double, double>& b) const {
    return std::max(a.first - b.second, b.first - a.second) > kFar * m_node_reach;
  }

  // A leaf counts by its corners: boxes of long faces that lie askew are far larger than these.
  bool leaf_is_apart(Index ia, Index ib) {
    const bool leaf_a = m_object_nodes.bvh().nodes[ia].is_leaf();
    return are_far(leaf_a ? along_plane(faces_a(ia)) : along(node_a(ia), kMoving, m_plane),
                   leaf_a ? along(node_b(ib), kFixed, m_plane) : along_plane(faces_b(ib)));
  }

  const Body &m_object, &m_support;
  double m_tolerance, m_slack;
  bool m_may_use_cones;
  Index m_num_pairs = 0;  // of faces that were tried
  std::optional<OpposedParts> m_parts;
  double m_node_reach = 0;  // with the rounding of nodes
  PairFrames m_frames;
  NodePlacer m_object_nodes, m_support_nodes;
  double m_reach;
  FeatureContacts m_features;
  SearchMemory& m_memory = memory_of_thread<SearchMemory>();
  const std::uint64_t m_search = new_search();
  Vec3 m_separating = Vec3::Zero();  // normal of the last plane between faces, of any length
  PlaneNormal m_plane;               // of the last one before these leaves
};

void collect_floor_vertices(const Body& object, const PlacedBvh& tree, Index node, double tolerance,
                            std::vector<Index>& vertices) {
  const PlacedBvh::Box box = tree.box(node);
  // A box that is higher than the tolerance ends the descent; the rounding of its centre is allowed
  // for.
  if (box.centre.z() - box.half.z() > tolerance * 1.001 + 1e-14 * std::abs(box.centre.z())) return;
  const BvhNode& n = tree.bvh.nodes[node];
  if (!n.is_leaf()) {
    collect_floor_vertices(object, tree, node + 1, tolerance, vertices);
    collect_floor_vertices(object, tree, n.second_child, tolerance, vertices);
    return;
  }
  for (Index i = 0; i < n.num_faces; ++i)
    for (const Index v : object.shape->mesh.triangles[tree.bvh.faces[n.second_child + i]])
      if (object.vertex(v).z() <= tolerance) vertices.push_back(v);
}

std::vector<ContactPoint> find_contact_points(const Body& object, const Body& support,
                                              double tolerance, double slack, bool by_cones) {
  // Bodies that are far apart, which most pairs of a scene are, build nothing.
  if (!overlaps(object.world_box, support.world_box, tolerance * 1.001)) return {};
  // One order for both ways round: the same pair gives the same bits, whoever asks.
  const bool from_support = comes_first(support, object);
  const Body &first = from_support ? support : object, &second = from_support ? object : support;
  const auto find = [&] { return ContactSearch(first, second, tolerance, slack, by_cones).run(); };
  ContactMemory* const memory = by_cones ? ContactMemory::current() : nullptr;
  std::vector<ContactPoint> points =
      memory ? memory->points(first, second, tolerance, slack, find) : find();
  if (from_support)
    for (ContactPoint& p : points) p = seen_from_support(p);
  return points;
}

}  // namespace

std::vector<ContactPoint> contact_points(const Body& object, const Body& support, double tolerance,
                                         double slack) {
  return find_contact_points(object, support, tolerance, slack, true);
}

std::vector<ContactPoint> contact_points_of_all_faces(const Body& object, const Body& support,
                                                      double tolerance, double slack) {
  return find_contact_points(object, support, tolerance, slack, false);
}

std::vector<ContactPoint> floor_contact_points(const Body& object, double tolerance) {
  std::vector<Index> vertices;
  if (object.shape->has_faces())
    collect_floor_vertices(object, PlacedBvh(object), 0, tolerance, vertices);
  // Faces share their vertices.
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<ContactPoint> out;
  for (const Index v : vertices) {
    const Vec3 p = object.vertex(v);
    out.push_back({p, Vec3::UnitZ(), std::max(0.0, p.z()), ContactFeatures::VertexFace, v, 0});
  }
  return out;
}

}  // namespace trivet
