#include "core/contact/feature_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/tunables.h"
#include "core/contact/dips.h"
#include "core/contact/rounding.h"
#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

constexpr double kParallelSine = 1e-6;   // edges closer to parallel than this do not cross
constexpr double kClearlyBeyond = 1e-6;  // of an edge: more than rounding

/// One side of a plane, or both.
struct NormalsToTry {
  std::array<Vec3, 2> normal;
  size_t num;

  const Vec3* begin() const { return normal.data(); }
  const Vec3* end() const { return normal.data() + num; }
};

// The normal on the side of a feature at p that is `height` over a plane. Where the height is
// rounding, both sides are tried, the front of the faces first.
NormalsToTry normals_at(double height, const Vec3& normal, const Vec3& p, const Vec3& front) {
  const bool rounding = std::abs(height) <= kRounding * p.cwiseAbs().maxCoeff();
  if ((rounding ? normal.dot(front) : height) < 0) return {{-normal, normal}, rounding ? 2u : 1u};
  return {{normal, -normal}, rounding ? 2u : 1u};
}

}  // namespace

std::vector<ContactPoint> FeatureContacts::ends_and_corners() {
  std::vector<ContactPoint> out = m_ends.points();
  for (const ContactPoint& p : m_flush.corners()) out.push_back(p);
  return out;
}

void FeatureContacts::add(const ContactFace& a, Index face_a, const ContactFace& b, Index face_b,
                          const FacingFeatures& facing) {
  if (b.separates(a.corners, m_tolerance) || a.separates(b.corners, m_tolerance)) return;
  m_near.push_back({face_a, face_b});
  const Index3 &va = m_object.shape->mesh.triangles[face_a],
               &vb = m_support.shape->mesh.triangles[face_b];
  // Six vertices go against the other face; those that do not touch it may still be ends of edges.
  const Index3 &ea = m_object.shape->adjacency.face_edges[face_a],
               &eb = m_support.shape->adjacency.face_edges[face_b];
  for (int k = 0; k < 3; ++k) {
    if (facing.a.vertices[k] && (!b.valid || !try_vertex_face(a.corners[k], va[k], b, face_b)))
      m_ends.add_vertex(a.corners[k], va[k], face_a, b, vb, eb, face_b, facing.b);
    if (facing.b.vertices[k] && (!a.valid || !try_face_vertex(b.corners[k], vb[k], a, face_a)))
      m_ends.add_support_vertex(a, ea, face_a, facing.a, b.corners[k], vb[k], face_b);
  }
  // Nine pairs of edges are left, of which most are told apart by their boxes.
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (facing.a.edges[i] && facing.b.edges[j] && overlaps(a.edge_box[i], b.edge_box[j], m_reach))
        try_edges(a, i, ea[i], b, j, eb[j]);
  // Flat overlaps, which rounding hides from vertices and edges, are collected apart.
  m_flush.add(a, face_a, b, face_b);
}

// Distance by which a foot may lie past the end of a feature: small against the height, as the
// direction between the surfaces changes there.
double FeatureContacts::slack_at(double height) const {
  return std::min(m_slack, kFootSlope * height);
}

// Seen from behind, a face ends at its rim, where the body may go on: the sides of two boxes in one
// plane touch nowhere, though their rims do.
bool FeatureContacts::rim_dips(const Body& body, Index face, const ContactFace& f, const Vec3& foot,
                               const Vec3& up) const {
  const Index3 &edges = body.shape->adjacency.face_edges[face],
               &vertices = body.shape->mesh.triangles[face];
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = foot - f.corners[k];
    const Vec3 along = d - f.normal.dot(d) * f.normal, outward = f.edge[k].cross(f.normal);
    if (along.squaredNorm() <= m_slack * m_slack &&
        vertex_dips(body, vertices[k], f.corners[k], up))
      return true;
    if (edges[k] >= 0 && -outward.dot(d) <= m_slack * outward.norm() &&
        edge_dips(body, edges[k], f.corners[k], up))
      return true;
  }
  return false;
}

// @return false if it may touch an edge or a corner of the face, too: within the slack, or where
// its own body goes on downwards.
bool FeatureContacts::try_vertex_face(const Vec3& p, Index vertex, const ContactFace& b,
                                      Index face) {
  const double height = b.normal.dot(p - b.corners[0]);
  if (std::abs(height) > m_tolerance) return true;
  if (!b.is_below(p, slack_at(std::abs(height)))) return false;
  // A vertex from which its own body goes on downwards is not the one that rests.
  for (const Vec3& normal : normals_at(height, b.normal, p, b.normal)) {
    if (vertex_dips(m_object, vertex, p, normal)) continue;
    if (normal.dot(b.normal) < 0 && rim_dips(m_support, face, b, p, -normal)) continue;
    m_found.push_back({p, normal, std::abs(height), ContactFeatures::VertexFace, vertex, face});
    return b.is_below(p, 0);
  }
  return false;
}

bool FeatureContacts::try_face_vertex(const Vec3& q, Index vertex, const ContactFace& a,
                                      Index face) {
  const double height = a.normal.dot(q - a.corners[0]);
  if (std::abs(height) > m_tolerance) return true;
  if (!a.is_below(q, slack_at(std::abs(height)))) return false;
  for (const Vec3& up : normals_at(height, a.normal, q, a.normal)) {
    if (vertex_dips(m_support, vertex, q, up)) continue;
    if (up.dot(a.normal) < 0 && rim_dips(m_object, face, a, q, -up)) continue;
    m_found.push_back({q, -up, std::abs(height), ContactFeatures::FaceVertex, face, vertex});
    return a.is_below(q, 0);
  }
  return false;
}

bool FeatureContacts::past_end(double s, const Vec3& edge, double height) const {
  // The ends of an edge may be passed by as much as a foot may lie beside a face.
  if (s >= 0 && s <= 1) return false;
  const double slack = slack_at(height) / edge.norm();
  return s < -slack || s > 1 + slack;
}

// True only if past_end(along / squared, edge, height), whatever the height.
bool FeatureContacts::clearly_past_end(double along, double squared, const Vec3& edge) const {
  const double beyond = std::max(-along, along - squared);
  return beyond > kClearlyBeyond * squared &&
         beyond * beyond * edge.squaredNorm() > 1.001 * m_slack * m_slack * squared * squared;
}

void FeatureContacts::try_edges(const ContactFace& a, int i, Index edge_a, const ContactFace& b,
                                int j, Index edge_b) {
  const Vec3 &u = a.edge[i], &v = b.edge[j];
  // Two skew lines are as far apart as the offset's part along their common normal.
  const Vec3 n = u.cross(v), r = b.corners[j] - a.corners[i];
  const double squared = n.squaredNorm(), along = n.dot(r);
  if (along * along > 1.001 * m_tolerance * m_tolerance * squared) return;  // too far, no root
  // Most feet are clearly past an end, which takes no root either.
  const Vec3 r_v = r.cross(v), r_u = r.cross(u);
  if (clearly_past_end(r_v.dot(n), squared, u) || clearly_past_end(r_u.dot(n), squared, v)) return;
  const double length_n = std::sqrt(squared);
  if (length_n <= kParallelSine * u.norm() * v.norm()) return;
  const Vec3 unit = n / length_n;
  const double height = -unit.dot(r);  // of a over b
  if (std::abs(height) > m_tolerance) return;
  // The feet of the common perpendicular have to lie on both edges.
  const double s = r_v.dot(unit) / length_n;
  if (past_end(s, u, std::abs(height))) return;
  const double t = r_u.dot(unit) / length_n;
  if (past_end(t, v, std::abs(height))) return;
  const Vec3 pa = a.corners[i] + s * u, pb = b.corners[j] + t * v;
  for (const Vec3& normal : normals_at(height, unit, pa, b.normal - a.normal)) {
    if (edge_dips_near_ends(m_object, edge_a, pa, normal, m_slack) ||
        edge_dips_near_ends(m_support, edge_b, pb, -normal, m_slack))
      continue;
    m_found.push_back(
        {0.5 * (pa + pb), normal, std::abs(height), ContactFeatures::EdgeEdge, edge_a, edge_b});
    return;
  }
}

std::vector<ContactPoint> FeatureContacts::closest_points() const {
  std::vector<ContactPoint> out;
  for (const auto& [face_a, face_b] : m_near) {
    const ClosestPoints c =
        trivet::closest_points(m_object.triangle(face_a), m_support.triangle(face_b));
    if (c.distance > m_tolerance || c.distance == 0) continue;
    out.push_back({c.point_b, (c.point_a - c.point_b) / c.distance, c.distance,
                   ContactFeatures::ClosestPoints, face_a, face_b});
  }
  return out;
}

}  // namespace trivet
