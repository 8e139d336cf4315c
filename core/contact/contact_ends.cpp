#include "core/contact/contact_ends.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "core/contact/dips.h"

namespace trivet {
namespace {

constexpr double kNoDirection = 1e-13;  // distance, of the coordinates, that has no direction

// A template, as the class keeps the type of ends to itself.
auto features_of_end(const auto& end) { return std::tie(end.kind, end.on_object, end.on_support); }

}  // namespace

void ContactEnds::add_vertex(const Vec3& p, Index vertex, Index face_a, const ContactFace& b,
                             const Index3& corners, const Index3& edges, Index face_b,
                             const FacingFeatures::OfFace& tried) {
  // Ends at the object's own edges are left to add_support_vertex(), so that no pair of vertices is
  // found twice.
  for (int k = 0; k < 3; ++k) {
    if (tried.vertices[k] && (p - b.corners[k]).squaredNorm() <= m_tolerance * m_tolerance)
      m_ends.push_back({End::Kind::Vertices, vertex, corners[k], face_a, face_b, p, b.corners[k]});
    if (!tried.edges[k]) continue;
    if (const auto q = foot(p, b, k))
      m_ends.push_back({End::Kind::VertexEdge, vertex, edges[k], face_a, face_b, p, *q});
  }
}

void ContactEnds::add_support_vertex(const ContactFace& a, const Index3& edges, Index face_a,
                                     const FacingFeatures::OfFace& tried, const Vec3& q,
                                     Index vertex, Index face_b) {
  for (int k = 0; k < 3; ++k) {
    if (!tried.edges[k]) continue;
    if (const auto p = foot(q, a, k))
      m_ends.push_back({End::Kind::EdgeVertex, edges[k], vertex, face_a, face_b, *p, q});
  }
}

// The foot of x on the inside of an edge that is near.
std::optional<Vec3> ContactEnds::foot(const Vec3& x, const ContactFace& face, int k) const {
  // A comparison of boxes rejects most edges before anything is divided.
  const Aabb& box = face.edge_box[k];
  if (((x - box.lower).array() < -m_reach).any() || ((x - box.upper).array() > m_reach).any())
    return std::nullopt;
  // The ends of an edge are its vertices, and count as pairs of vertices.
  const double s = face.edge[k].dot(x - face.corners[k]) / face.edge[k].squaredNorm();
  if (!(s > 0 && s < 1)) return std::nullopt;
  const Vec3 foot = face.corners[k] + s * face.edge[k];
  if ((x - foot).squaredNorm() > m_tolerance * m_tolerance) return std::nullopt;
  return foot;
}

// One of the surfaces comes nearer beside: the other is not where they are nearest.
bool ContactEnds::dips(const End& end, const Vec3& normal) const {
  const bool object_dips =
      end.kind == End::Kind::EdgeVertex
          ? edge_dips_near_ends(m_object, end.on_object, end.p, normal, m_slack)
          : vertex_dips(m_object, end.on_object, end.p, normal);
  if (object_dips) return true;
  return end.kind == End::Kind::VertexEdge
             ? edge_dips_near_ends(m_support, end.on_support, end.q, -normal, m_slack)
             : vertex_dips(m_support, end.on_support, end.q, -normal);
}

std::vector<ContactPoint> ContactEnds::points() {
  // A face that names a vertex twice reports its ends twice.
  std::sort(m_ends.begin(), m_ends.end(), [](const auto& x, const auto& y) {
    return std::tuple_cat(features_of_end(x), std::tie(x.face_object, x.face_support)) <
           std::tuple_cat(features_of_end(y), std::tie(y.face_object, y.face_support));
  });
  m_ends.erase(std::unique(m_ends.begin(), m_ends.end(),
                           [](const auto& x, const auto& y) {
                             return features_of_end(x) == features_of_end(y);
                           }),
               m_ends.end());
  std::vector<ContactPoint> out;
  for (const End& end : m_ends) {
    // Points that coincide to rounding have no direction between them, and so no normal.
    const double distance = (end.p - end.q).norm();
    if (distance <= kNoDirection * end.p.cwiseAbs().maxCoeff()) continue;
    const Vec3 normal = (end.p - end.q) / distance;
    if (dips(end, normal)) continue;
    out.push_back({end.kind == End::Kind::VertexEdge ? end.p : end.q, normal, distance,
                   ContactFeatures::ClosestPoints, end.face_object, end.face_support});
  }
  return out;
}

}  // namespace trivet
