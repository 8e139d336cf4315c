// Contacts at the ends of parallel edges: vertices near an edge or another vertex. Private.
#pragma once

#include <optional>
#include <vector>

#include "core/contact/body.h"
#include "core/contact/contact.h"
#include "core/contact/contact_face.h"
#include "core/contact/opposed_parts.h"

namespace trivet {

/// Collects them from pairs of faces that are near; see contact_points().
class ContactEnds {
 public:
  /// Keeps references. @param reach  `tolerance` with the rounding of boxes.
  /// @param slack  as of contact_points().
  ContactEnds(const Body& object, const Body& support, double tolerance, double reach, double slack)
      : m_object(object),
        m_support(support),
        m_tolerance(tolerance),
        m_reach(reach),
        m_slack(slack) {}

  /// A vertex of the object beside a face of the support: near an edge of it, or a corner.
  /// @param tried  features of `b`; its others are left out.
  void add_vertex(const Vec3& p, Index vertex, Index face_a, const ContactFace& b,
                  const Index3& corners, const Index3& edges, Index face_b,
                  const FacingFeatures::OfFace& tried);
  /// A vertex of the support beside a face of the object: near an edge of it.
  void add_support_vertex(const ContactFace& a, const Index3& edges, Index face_a,
                          const FacingFeatures::OfFace& tried, const Vec3& q, Index vertex,
                          Index face_b);

  /// Points where neither surface comes nearer beside, each once.
  std::vector<ContactPoint> points();

 private:
  // Two vertices, or a vertex and a place inside an edge.
  struct End {
    enum class Kind { VertexEdge, EdgeVertex, Vertices };
    Kind kind;
    Index on_object, on_support;  // vertex or edge
    Index face_object, face_support;
    Vec3 p, q;  // on the object and on the support
  };

  std::optional<Vec3> foot(const Vec3& x, const ContactFace& face, int k) const;
  bool dips(const End& end, const Vec3& normal) const;

  const Body &m_object, &m_support;
  double m_tolerance, m_reach, m_slack;
  std::vector<End> m_ends;
};

}  // namespace trivet
