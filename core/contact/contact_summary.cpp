// Contact points summed up: merged, their hull, type and faces.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/base/cross.h"
#include "core/contact/contact_points.h"
#include "core/contact/plane_axes.h"

namespace trivet {
namespace {

Vec3 mean_normal(const std::vector<ContactPoint>& points) {
  // Opposite normals cancel, and leave no mean: then the first one stands for all.
  Vec3 sum = Vec3::Zero();
  for (const ContactPoint& p : points) sum += p.normal;
  const double length = sum.norm();
  return length > 1e-9 * points.size() ? Vec3(sum / length) : points.front().normal;
}

void add_faces(const Body& body, ContactFeatures features, bool is_object, Index feature,
               std::vector<Index>& faces) {
  const Adjacency& adjacency = body.shape->adjacency;
  // The kind of feature tells what the index names on this body: a face, an edge, or a vertex with
  // the faces around it.
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

constexpr size_t kManyPoints = 24;
constexpr double kInside = 1e-9;  // of the extent: no rounding makes such a point a corner

// Leaves out points inside the octagon of the extreme ones: most of those of flush faces, which
// need not be sorted then [Akl 1978].
void drop_inner(std::vector<Vec2>& points) {
  constexpr size_t kDirections = 8;
  const std::array<Vec2, kDirections> directions{Vec2(1, 0),  Vec2(1, 1),  Vec2(0, 1),
                                                 Vec2(-1, 1), Vec2(-1, 0), Vec2(-1, -1),
                                                 Vec2(0, -1), Vec2(1, -1)};
  std::array<Vec2, kDirections> corners;
  corners.fill(points.front());
  // The farthest point in each of eight directions is a corner of the octagon.
  for (const Vec2& p : points)
    for (size_t k = 0; k < kDirections; ++k)
      if (directions[k].dot(p) > directions[k].dot(corners[k])) corners[k] = p;
  // The limit is a part of the extent's area, so that it scales with the model.
  const double extent = (corners[0] - corners[4]).cwiseAbs().maxCoeff() +
                        (corners[2] - corners[6]).cwiseAbs().maxCoeff();
  const double inside = kInside * extent * extent;
  std::erase_if(points, [&](const Vec2& p) {
    for (size_t k = 0; k < kDirections; ++k) {
      // Directions that share a corner give an edge without length, which says nothing.
      const Vec2 &a = corners[k], &b = corners[(k + 1) % kDirections];
      if (a != b && !(cross(b - a, p - a) > inside)) return false;
    }
    return inside > 0;
  });
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

bool is_less(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

// Less in the order of meshes of as many vertices and faces. Differs at the first vertex, mostly.
bool is_less(const Mesh& a, const Mesh& b) {
  if (a.vertices != b.vertices)
    return std::lexicographical_compare(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                                        b.vertices.end(),
                                        [](const Vec3& p, const Vec3& q) { return is_less(p, q); });
  return a.triangles < b.triangles;
}

}  // namespace

bool comes_first(const Body& a, const Body& b) {
  const Mesh &ma = a.shape->mesh, &mb = b.shape->mesh;
  const auto sizes = [](const Mesh& m) {
    return std::make_pair(m.triangles.size(), m.vertices.size());
  };
  if (sizes(ma) != sizes(mb)) return sizes(ma) < sizes(mb);
  const Affine &pa = a.world_from_object, &pb = b.world_from_object;
  if (pa.translation != pb.translation) return is_less(pa.translation, pb.translation);
  for (int k = 0; k < 3; ++k)
    if (pa.linear.col(k) != pb.linear.col(k)) return is_less(pa.linear.col(k), pb.linear.col(k));
  return &ma != &mb && is_less(ma, mb);
}

ContactPoint seen_from_support(ContactPoint p) {
  p.normal = -p.normal;
  std::swap(p.feature_object, p.feature_support);
  if (p.features == ContactFeatures::VertexFace)
    p.features = ContactFeatures::FaceVertex;
  else if (p.features == ContactFeatures::FaceVertex)
    p.features = ContactFeatures::VertexFace;
  return p;
}

Contact seen_from_support(Contact contact) {
  contact.normal = -contact.normal;
  std::reverse(contact.hull.begin(), contact.hull.end());
  std::swap(contact.faces_object, contact.faces_support);
  for (ContactPoint& p : contact.points) p = seen_from_support(p);
  return contact;
}

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

bool same_place(const ContactPoint& p, const ContactPoint& q, double distance) {
  return (p.point - q.point).squaredNorm() <= distance * distance &&
         p.normal.dot(q.normal) >= 1 - 0.5e-4;
}

std::vector<ContactPoint> merged(const std::vector<ContactPoint>& points, double distance) {
  // Sorted along the widest extent, each point is compared with those within reach only.
  Aabb box;
  for (const ContactPoint& p : points) box.extend(p.point);
  int along = 0;
  if (!points.empty()) box.half_extent().maxCoeff(&along);
  std::vector<std::pair<double, Index>> order;  // side by side: points lie far apart in memory
  order.reserve(points.size());
  for (const ContactPoint& p : points)
    order.emplace_back(p.point[along], static_cast<Index>(order.size()));
  std::sort(order.begin(), order.end());
  std::vector<char> dropped(points.size(), 0);
  const auto better = [&](Index a, Index b) {
    return std::make_tuple(points[a].gap, a) < std::make_tuple(points[b].gap, b);
  };
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size(); ++j) {
      const auto [at, a] = order[i];
      const auto [other_at, b] = order[j];
      // A dropped point drops no others, so that a chain of near points does not vanish into one.
      if (dropped[a] || other_at - at > distance) break;
      if (dropped[b] || !same_place(points[a], points[b], distance)) continue;
      dropped[better(a, b) ? b : a] = 1;
    }
  std::vector<ContactPoint> out;
  for (size_t i = 0; i < points.size(); ++i)
    if (!dropped[i]) out.push_back(points[i]);
  return out;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  if (points.size() >= kManyPoints) drop_inner(points);
  // Monotone chain [Andrew 1979].
  const auto less = [](const Vec2& a, const Vec2& b) {
    return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  // The first pass makes the lower chain, the second the upper one from the reversed points.
  for (int pass = 0; pass < 2; ++pass) {
    const size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
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
  if (support && comes_first(*support, object)) {
    // A pair's contact is computed from the body that comes first, so that both ways round give the
    // same bits.
    std::vector<ContactPoint> of_support;
    of_support.reserve(points.size());
    for (const ContactPoint& p : points) of_support.push_back(seen_from_support(p));
    return seen_from_support(make_contact(of_support, *support, &object, extent));
  }
  Contact out;
  out.points = points;
  if (points.empty()) return out;
  out.normal = mean_normal(points);
  out.gap = kInfinity;
  // Points are projected into the contact plane; the first of them is the origin, which keeps
  // digits where the world's origin is far.
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
  // The hull in the plane tells whether it is a point, a line or an area.
  const std::vector<Vec2> hull = convex_hull(flat);
  for (const Vec2& p : hull) out.hull.push_back(origin + p.x() * u + p.y() * v);
  out.type = type_of(hull, extent);
  return out;
}

}  // namespace trivet
