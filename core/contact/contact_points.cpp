#include "core/contact/contact_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/tunables.h"
#include "core/contact/leaf_box.h"
#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

constexpr double kParallelSine = 1e-6;  // edges closer to parallel than this do not cross
constexpr double kFlatFace = 1e-9;      // height over length below which a face has no normal

auto features_of(const ContactPoint& c) {
  return std::tie(c.features, c.feature_object, c.feature_support);
}

// Two pairs of faces may see the same edges meet a rounding apart: the order must not depend on
// which came first.
auto order_of(const ContactPoint& c) {
  return std::make_tuple(features_of(c), c.gap, c.point.x(), c.point.y(), c.point.z());
}

struct FacePlane {
  Vec3 normal;                  // unit
  std::array<Vec3, 3> outward;  // unit, in the plane, away from each edge
  bool valid = false;

  explicit FacePlane(const Triangle& t) {
    const std::array<Vec3, 3> edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    const Vec3 n = edge[0].cross(edge[1]);
    const double area = n.norm();
    const double longest =
        std::max({edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm()});
    if (area <= kFlatFace * longest) return;
    valid = true;
    normal = n / area;
    for (int k = 0; k < 3; ++k) outward[k] = edge[k].cross(normal).normalized();
  }
};

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
    std::vector<ContactPoint>& out = m_found.empty() ? m_fallback : m_found;
    std::stable_sort(out.begin(), out.end(), [](const ContactPoint& a, const ContactPoint& b) {
      return order_of(a) < order_of(b);
    });
    const auto last =
        std::unique(out.begin(), out.end(), [](const ContactPoint& a, const ContactPoint& b) {
          return features_of(a) == features_of(b);
        });
    out.erase(last, out.end());
    return std::move(out);
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
    for (Index i = 0; i < a.num_faces; ++i)
      for (Index j = 0; j < b.num_faces; ++j)
        try_faces(m_tree_object.bvh.faces[a.second_child + i],
                  m_tree_support.bvh.faces[b.second_child + j]);
  }

  // One side of the plane, and farther than the tolerance.
  bool separated(const Triangle& t, const Triangle& face, const FacePlane& plane) const {
    if (!plane.valid) return false;
    const double h[3] = {plane.normal.dot(t[0] - face[0]), plane.normal.dot(t[1] - face[0]),
                         plane.normal.dot(t[2] - face[0])};
    return std::min({h[0], h[1], h[2]}) > m_tolerance ||
           std::max({h[0], h[1], h[2]}) < -m_tolerance;
  }

  void try_faces(Index face_a, Index face_b) {
    const Triangle a = m_object.triangle(face_a), b = m_support.triangle(face_b);
    const FacePlane plane_a(a), plane_b(b);
    if (separated(a, b, plane_b) || separated(b, a, plane_a)) return;
    const Index3 &va = m_object.shape->mesh.triangles[face_a],
                 &vb = m_support.shape->mesh.triangles[face_b];
    for (int k = 0; k < 3; ++k) {
      if (plane_b.valid) try_vertex_face(a[k], va[k], b, plane_b, face_b);
      if (plane_a.valid) try_face_vertex(b[k], vb[k], a, plane_a, face_a);
    }
    const Index3 &ea = m_object.shape->adjacency.face_edges[face_a],
                 &eb = m_support.shape->adjacency.face_edges[face_b];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (ea[i] >= 0 && eb[j] >= 0) try_edges(a, i, ea[i], b, j, eb[j]);
    if (m_found.empty()) try_closest(a, face_a, b, face_b);
  }

  bool over(const Vec3& p, const Triangle& face, const FacePlane& plane) const {
    for (int k = 0; k < 3; ++k)
      if (plane.outward[k].dot(p - face[k]) > m_slack) return false;
    return true;
  }

  void try_vertex_face(const Vec3& p, Index vertex, const Triangle& b, const FacePlane& plane,
                       Index face) {
    const double height = plane.normal.dot(p - b[0]);
    if (std::abs(height) > m_tolerance || !over(p, b, plane)) return;
    const Vec3 normal = height < 0 ? Vec3(-plane.normal) : plane.normal;
    if (vertex_dips(m_object, vertex, p, normal)) return;
    m_found.push_back({p, normal, std::abs(height), ContactFeatures::VertexFace, vertex, face});
  }

  void try_face_vertex(const Vec3& q, Index vertex, const Triangle& a, const FacePlane& plane,
                       Index face) {
    const double height = plane.normal.dot(q - a[0]);
    if (std::abs(height) > m_tolerance || !over(q, a, plane)) return;
    const Vec3 normal = height > 0 ? Vec3(-plane.normal) : plane.normal;
    if (vertex_dips(m_support, vertex, q, -normal)) return;
    m_found.push_back({q, normal, std::abs(height), ContactFeatures::FaceVertex, face, vertex});
  }

  void try_edges(const Triangle& a, int i, Index edge_a, const Triangle& b, int j, Index edge_b) {
    const Vec3 u = a[(i + 1) % 3] - a[i], v = b[(j + 1) % 3] - b[j];
    const Vec3 n = u.cross(v);
    const double length_n = n.norm(), length_u = u.norm(), length_v = v.norm();
    if (length_n <= kParallelSine * length_u * length_v) return;
    const Vec3 unit = n / length_n, r = b[j] - a[i];
    const double height = -unit.dot(r);  // of a over b
    if (std::abs(height) > m_tolerance) return;
    const double s = r.cross(v).dot(unit) / length_n, t = r.cross(u).dot(unit) / length_n;
    const double slack_s = m_slack / length_u, slack_t = m_slack / length_v;
    if (s < -slack_s || s > 1 + slack_s || t < -slack_t || t > 1 + slack_t) return;
    const Vec3 pa = a[i] + s * u, pb = b[j] + t * v;
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
