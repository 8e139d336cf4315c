// Contacts between features of two faces: vertices over faces, crossing edges, closest points.
// Private.
#pragma once

#include <array>
#include <vector>

#include "core/contact/body.h"
#include "core/contact/contact.h"
#include "core/contact/contact_ends.h"
#include "core/contact/contact_face.h"
#include "core/contact/flush_faces.h"
#include "core/contact/opposed_parts.h"

namespace trivet {

/// Collects the contacts of pairs of faces that are near; see contact_points().
class FeatureContacts {
 public:
  /// Keeps references. @param reach  `tolerance` with the rounding of boxes.
  FeatureContacts(const Body& object, const Body& support, double tolerance, double reach,
                  double slack)
      : m_object(object),
        m_support(support),
        m_tolerance(tolerance),
        m_reach(reach),
        m_slack(slack),
        m_flush(object, support, tolerance, slack),
        m_ends(object, support, tolerance, reach, slack) {}

  /// @param facing  other features are left out; each pair of them is to come once.
  void add(const ContactFace& a, Index face_a, const ContactFace& b, Index face_b,
           const FacingFeatures& facing);

  /// Features of both bodies.
  const std::vector<ContactPoint>& found() const { return m_found; }
  /// Ends of parallel edges, and corners of flush overlaps.
  std::vector<ContactPoint> ends_and_corners();
  /// Closest points of faces that no plane of either has told apart.
  std::vector<ContactPoint> closest_points() const;

 private:
  double slack_at(double height) const;
  bool rim_dips(const Body& body, Index face, const ContactFace& f, const Vec3& foot,
                const Vec3& up) const;
  bool try_vertex_face(const Vec3& p, Index vertex, const ContactFace& b, Index face);
  bool try_face_vertex(const Vec3& q, Index vertex, const ContactFace& a, Index face);
  bool past_end(double s, const Vec3& edge, double height) const;
  bool clearly_past_end(double along, double squared, const Vec3& edge) const;
  void try_edges(const ContactFace& a, int i, Index edge_a, const ContactFace& b, int j,
                 Index edge_b);

  const Body &m_object, &m_support;
  double m_tolerance, m_reach, m_slack;
  FlushFaces m_flush;
  ContactEnds m_ends;
  std::vector<ContactPoint> m_found;
  std::vector<std::array<Index, 2>> m_near;  // faces that no plane of either has told apart
};

}  // namespace trivet
