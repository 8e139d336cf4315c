#include "core/contact/contact_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/tunables.h"
#include "core/contact/contact_face.h"
#include "core/contact/leaf_box.h"
#include "core/contact/pair_set.h"
#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

constexpr double kParallelSine = 1e-6;  // edges closer to parallel than this do not cross

auto features_of(const ContactPoint& c) {
  return std::tie(c.features, c.feature_object, c.feature_support);
}

// Two pairs of faces may see the same edges meet a rounding apart: the order must not depend on
// which came first.
auto order_of(const ContactPoint& c) {
  return std::make_tuple(features_of(c), c.gap, c.point.x(), c.point.y(), c.point.z());
}

// Sorted, every pair of features once.
std::vector<ContactPoint> first_of_each(const std::vector<ContactPoint>& points) {
  std::vector<const ContactPoint*> order;
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

Aabb box_of(const Triangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

class ContactSearch {
 public:
  ContactSearch(const Body& object, const Body& support, double tolerance, double slack)
      : m_object(object),
        m_support(support),
        m_tolerance(tolerance),
        m_slack(slack),
        m_frame(support),
        m_tree_object(m_frame.tree(object)),
        m_tree_support(m_frame.own_tree(support)),
        m_own_axis{m_tree_object.own_axis(0), m_tree_object.own_axis(1),
                   m_tree_object.own_axis(2)} {
    m_reach = tolerance * 1.001 + 1e-14 * m_tree_object.translation.cwiseAbs().maxCoeff();
  }

  std::vector<ContactPoint> run() {
    if (!m_object.shape->bvh.nodes.empty() && !m_support.shape->bvh.nodes.empty())
      visit(0, 0, m_tree_object.box(0), m_tree_support.box(0), nullptr);
    return first_of_each(m_found.empty() ? m_fallback : m_found);
  }

 private:
  bool apart(const BoxTree::Box& a, const BoxTree::Box& b) const {
    const Vec3 d = a.centre - b.centre;
    if ((d.cwiseAbs().array() > (a.half + b.half).array() + m_reach).any()) return true;
    for (int k = 0; k < 3; ++k) {
      const Vec3& n = m_own_axis[k];
      if (std::abs(n.dot(d)) > a.own_half[k] + n.cwiseAbs().dot(b.half) + m_reach) return true;
    }
    return false;
  }

  // `leaf` is the tight box of the node that is a leaf already.
  void visit(Index ia, Index ib, const BoxTree::Box& box_a, const BoxTree::Box& box_b,
             const LeafBox* leaf) {
    if (apart(box_a, box_b)) return;
    const BvhNode &a = m_tree_object.bvh.nodes[ia], &b = m_tree_support.bvh.nodes[ib];
    if (leaf && leaf->valid && leaf->gap(a.is_leaf() ? box_b : box_a) > m_reach) return;
    if (a.is_leaf() && b.is_leaf()) return try_leaves(a, b);
    std::optional<LeafBox> own;
    if (!leaf && (a.is_leaf() || b.is_leaf())) {
      own.emplace(a.is_leaf() ? LeafBox(m_object, a, m_frame) : LeafBox(m_support, b, m_frame));
      leaf = &*own;
    }
    if (!a.is_leaf() && (b.is_leaf() || box_a.radius > box_b.radius)) {
      visit(ia + 1, ib, m_tree_object.box(ia + 1), box_b, leaf);
      visit(a.second_child, ib, m_tree_object.box(a.second_child), box_b, leaf);
    } else {
      visit(ia, ib + 1, box_a, m_tree_support.box(ib + 1), leaf);
      visit(ia, b.second_child, box_a, m_tree_support.box(b.second_child), leaf);
    }
  }

  void try_leaves(const BvhNode& a, const BvhNode& b) {
    for (Index i = 0; i < a.num_faces; ++i) {
      const Index face_a = m_tree_object.bvh.faces[a.second_child + i];
      const Triangle ta = m_object.triangle(face_a);
      const Aabb box_a = box_of(ta);
      for (Index j = 0; j < b.num_faces; ++j) {
        const Index face_b = m_tree_support.bvh.faces[b.second_child + j];
        const Triangle tb = m_support.triangle(face_b);
        if (!overlaps(box_a, box_of(tb), m_reach)) continue;
        const PlainFace fa(ta), fb(tb);
        if (!fb.clearly_separates(ta, m_tolerance) && !fa.clearly_separates(tb, m_tolerance))
          try_faces(ContactFace(fa), face_a, ContactFace(fb), face_b);
      }
    }
  }

  void try_faces(const ContactFace& a, Index face_a, const ContactFace& b, Index face_b) {
    if (b.separates(a.corners, m_tolerance) || a.separates(b.corners, m_tolerance)) return;
    const Index3 &va = m_object.shape->mesh.triangles[face_a],
                 &vb = m_support.shape->mesh.triangles[face_b];
    for (int k = 0; k < 3; ++k) {
      if (b.valid) try_vertex_face(a.corners[k], va[k], b, face_b);
      if (a.valid) try_face_vertex(b.corners[k], vb[k], a, face_a);
    }
    const Index3 &ea = m_object.shape->adjacency.face_edges[face_a],
                 &eb = m_support.shape->adjacency.face_edges[face_b];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (ea[i] >= 0 && eb[j] >= 0 && overlaps(a.edge_box[i], b.edge_box[j], m_reach))
          try_edges(a, i, ea[i], b, j, eb[j]);
    if (m_found.empty()) try_closest(a.corners, face_a, b.corners, face_b);
  }

  void try_vertex_face(const Vec3& p, Index vertex, const ContactFace& b, Index face) {
    const double height = b.normal.dot(p - b.corners[0]);
    if (std::abs(height) > m_tolerance || !m_tried_vertices.insert(vertex, face)) return;
    if (!b.is_below(p, m_slack)) return;
    const Vec3 normal = height < 0 ? Vec3(-b.normal) : b.normal;
    if (vertex_dips(m_object, vertex, p, normal)) return;
    m_found.push_back({p, normal, std::abs(height), ContactFeatures::VertexFace, vertex, face});
  }

  void try_face_vertex(const Vec3& q, Index vertex, const ContactFace& a, Index face) {
    const double height = a.normal.dot(q - a.corners[0]);
    if (std::abs(height) > m_tolerance || !m_tried_faces.insert(face, vertex)) return;
    if (!a.is_below(q, m_slack)) return;
    const Vec3 normal = height > 0 ? Vec3(-a.normal) : a.normal;
    if (vertex_dips(m_support, vertex, q, -normal)) return;
    m_found.push_back({q, normal, std::abs(height), ContactFeatures::FaceVertex, face, vertex});
  }

  bool past_end(double s, const Vec3& edge) const {
    if (s >= 0 && s <= 1) return false;
    const double slack = m_slack / edge.norm();
    return s < -slack || s > 1 + slack;
  }

  void try_edges(const ContactFace& a, int i, Index edge_a, const ContactFace& b, int j,
                 Index edge_b) {
    const Vec3 &u = a.edge[i], &v = b.edge[j];
    const Vec3 n = u.cross(v), r = b.corners[j] - a.corners[i];
    const double squared = n.squaredNorm(), along = n.dot(r);
    if (along * along > 1.001 * m_tolerance * m_tolerance * squared) return;  // too far, no root
    const double length_n = std::sqrt(squared);
    if (length_n <= kParallelSine * u.norm() * v.norm()) return;
    const Vec3 unit = n / length_n;
    const double height = -unit.dot(r);  // of a over b
    if (std::abs(height) > m_tolerance) return;
    const double s = r.cross(v).dot(unit) / length_n;
    if (past_end(s, u)) return;
    const double t = r.cross(u).dot(unit) / length_n;
    if (past_end(t, v)) return;
    const Vec3 pa = a.corners[i] + s * u, pb = b.corners[j] + t * v;
    const Vec3 normal = height < 0 ? Vec3(-unit) : unit;
    if (edge_dips(m_object, edge_a, pa, normal) || edge_dips(m_support, edge_b, pb, -normal))
      return;
    m_found.push_back(
        {0.5 * (pa + pb), normal, std::abs(height), ContactFeatures::EdgeEdge, edge_a, edge_b});
  }

  void try_closest(const Triangle& a, Index face_a, const Triangle& b, Index face_b) {
    const ClosestPoints c = closest_points(a, b);
    if (c.distance > m_tolerance || c.distance == 0) return;
    m_fallback.push_back({c.point_b, (c.point_a - c.point_b) / c.distance, c.distance,
                          ContactFeatures::ClosestPoints, face_a, face_b});
  }

  // Whether a neighbour of the vertex lies below the plane through p.
  static bool vertex_dips(const Body& body, Index vertex, const Vec3& p, const Vec3& up) {
    for (const Index edge : body.shape->adjacency.vertex_edges[vertex]) {
      const auto& ends = body.shape->adjacency.edge_vertices[edge];
      if (dips(body.vertex(ends[0] == vertex ? ends[1] : ends[0]) - p, up)) return true;
    }
    return false;
  }

  // Whether a face at the edge goes below the plane through p.
  static bool edge_dips(const Body& body, Index edge, const Vec3& p, const Vec3& up) {
    for (const Wing& wing : body.shape->adjacency.edge_faces[edge])
      for (const Index vertex : body.shape->mesh.triangles[wing.face])
        if (dips(body.vertex(vertex) - p, up)) return true;
    return false;
  }

  static bool dips(const Vec3& d, const Vec3& up) { return up.dot(d) < -kConeSlope * d.norm(); }

  const Body &m_object, &m_support;
  double m_tolerance, m_slack, m_reach = 0;
  UnitFrame m_frame;
  BoxTree m_tree_object, m_tree_support;
  std::array<Vec3, 3> m_own_axis;  // of the object
  std::vector<ContactPoint> m_found, m_fallback;
  PairSet m_tried_vertices, m_tried_faces;  // of the object and the support, one of them a face
};

void collect_floor_vertices(const Body& object, const BoxTree& tree, Index node, double tolerance,
                            std::vector<Index>& vertices) {
  const BoxTree::Box box = tree.box(node);
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

// Right-handed axes in the plane perpendicular to n.
std::array<Vec3, 2> plane_axes(const Vec3& n) {
  int k = 0;
  n.cwiseAbs().minCoeff(&k);
  const Vec3 u = n.cross(Vec3::Unit(k)).normalized();
  return {u, n.cross(u)};
}

Vec3 mean_normal(const std::vector<ContactPoint>& points) {
  Vec3 sum = Vec3::Zero();
  for (const ContactPoint& p : points) sum += p.normal;
  const double length = sum.norm();
  return length > 1e-9 * points.size() ? Vec3(sum / length) : points.front().normal;
}

void add_faces(const Body& body, ContactFeatures features, bool is_object, Index feature,
               std::vector<Index>& faces) {
  const Adjacency& adjacency = body.shape->adjacency;
  const bool face =
      features == ContactFeatures::ClosestPoints ||
      features == (is_object ? ContactFeatures::FaceVertex : ContactFeatures::VertexFace);
  if (face) {
    faces.push_back(feature);
  } else if (features == ContactFeatures::EdgeEdge) {
    for (const Wing& w : adjacency.edge_faces[feature]) faces.push_back(w.face);
  } else {
    for (const Index f : adjacency.vertex_faces[feature]) faces.push_back(f);
  }
}

void sort_unique(std::vector<Index>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

ContactType type_of(const std::vector<Vec2>& hull, double extent) {
  // Largest distance of two hull points, and the width across that direction.
  double longest = 0;
  Vec2 along = Vec2::UnitX();
  for (const Vec2& p : hull)
    for (const Vec2& q : hull)
      if ((p - q).norm() > longest) longest = (p - q).norm(), along = p - q;
  if (longest <= extent) return ContactType::Point;
  const Vec2 across = Vec2(-along.y(), along.x()) / longest;
  double low = kInfinity, high = -kInfinity;
  for (const Vec2& p : hull) {
    low = std::min(low, across.dot(p));
    high = std::max(high, across.dot(p));
  }
  return high - low <= extent ? ContactType::Line : ContactType::Area;
}

double cross(const Vec2& o, const Vec2& a, const Vec2& b) {
  return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

}  // namespace

const char* to_string(ContactType type) {
  switch (type) {
    case ContactType::Point:
      return "point";
    case ContactType::Line:
      return "line";
    case ContactType::Area:
      return "area";
  }
  return "?";
}

std::vector<ContactPoint> contact_points(const Body& object, const Body& support, double tolerance,
                                         double slack) {
  if (!overlaps(object.world_box, support.world_box, tolerance * 1.001)) return {};
  return ContactSearch(object, support, tolerance, slack).run();
}

std::vector<ContactPoint> floor_contact_points(const Body& object, double tolerance) {
  std::vector<Index> vertices;
  if (!object.shape->bvh.nodes.empty())
    collect_floor_vertices(object, BoxTree(object), 0, tolerance, vertices);
  sort_unique(vertices);
  std::vector<ContactPoint> out;
  for (const Index v : vertices) {
    const Vec3 p = object.vertex(v);
    out.push_back({p, Vec3::UnitZ(), std::max(0.0, p.z()), ContactFeatures::VertexFace, v, 0});
  }
  return out;
}

std::vector<ContactPoint> merged(const std::vector<ContactPoint>& points, double distance) {
  // Sorted along the widest extent, each point is compared with those within reach only.
  Aabb box;
  for (const ContactPoint& p : points) box.extend(p.point);
  int along = 0;
  if (!points.empty()) box.half_extent().maxCoeff(&along);
  std::vector<Index> order(points.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::make_tuple(points[a].point[along], a) < std::make_tuple(points[b].point[along], b);
  });
  std::vector<char> dropped(points.size(), 0);
  const auto better = [&](Index a, Index b) {
    return std::make_tuple(points[a].gap, a) < std::make_tuple(points[b].gap, b);
  };
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size() && !dropped[order[i]]; ++j) {
      const ContactPoint &p = points[order[i]], &q = points[order[j]];
      if (q.point[along] - p.point[along] > distance) break;
      if (dropped[order[j]] || (p.point - q.point).squaredNorm() > distance * distance ||
          p.normal.dot(q.normal) < 1 - 0.5e-4)
        continue;
      dropped[better(order[i], order[j]) ? order[j] : order[i]] = 1;
    }
  std::vector<ContactPoint> out;
  for (size_t i = 0; i < points.size(); ++i)
    if (!dropped[i]) out.push_back(points[i]);
  return out;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  // Monotone chain [Andrew 1979].
  const auto less = [](const Vec2& a, const Vec2& b) {
    return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Contact make_contact(const std::vector<ContactPoint>& points, const Body& object,
                     const Body* support, double extent) {
  Contact out;
  out.points = points;
  if (points.empty()) return out;
  out.normal = mean_normal(points);
  out.gap = kInfinity;
  const auto [u, v] = plane_axes(out.normal);
  const Vec3 origin = points.front().point;
  std::vector<Vec2> flat;
  for (const ContactPoint& p : points) {
    out.gap = std::min(out.gap, p.gap);
    flat.emplace_back(u.dot(p.point - origin), v.dot(p.point - origin));
    add_faces(object, p.features, true, p.feature_object, out.faces_object);
    if (support) add_faces(*support, p.features, false, p.feature_support, out.faces_support);
  }
  sort_unique(out.faces_object);
  sort_unique(out.faces_support);
  const std::vector<Vec2> hull = convex_hull(flat);
  for (const Vec2& p : hull) out.hull.push_back(origin + p.x() * u + p.y() * v);
  out.type = type_of(hull, extent);
  return out;
}

}  // namespace trivet
