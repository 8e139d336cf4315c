// Corners of the overlap of flat faces that lie on each other. Private.
//
// Edges that are nearly parallel have no crossing and no common normal that rounding leaves alone,
// so a flat face on a flat face may show none of its corners as vertex over face or crossing edges.
// There one triangle is clipped by the other, seen along the normal of the larger one.
#pragma once

#include <vector>

#include "core/contact/body.h"
#include "core/contact/contact.h"
#include "core/contact/contact_face.h"

namespace trivet {

class FlushFaces {
 public:
  FlushFaces(const Body& object, const Body& support, double tolerance, double slack)
      : m_object(object), m_support(support), m_tolerance(tolerance), m_slack(slack) {}

  /// Keeps the overlap of two faces that are parallel to kConeSlope and look at each other.
  void add(const ContactFace& a, Index face_a, const ContactFace& b, Index face_b);

  /// Corners of the hull of what lies on each other of two neighbourhoods of coplanar faces.
  /// Cost O(overlaps log overlaps).
  std::vector<ContactPoint> corners() const;

 private:
  struct Overlap {
    Index face_object, face_support;
    size_t first, end;  // of m_corners
  };
  // A face in the overlaps of two neighbourhoods, which are named by a face of each.
  struct Member {
    Index object, support;
    size_t overlap;
  };

  std::vector<Member> members() const;
  void append_hull(std::span<const Member> patch, std::vector<ContactPoint>& out) const;

  const Body &m_object, &m_support;
  double m_tolerance, m_slack;
  std::vector<Overlap> m_overlaps;
  std::vector<ContactPoint> m_corners;
};

}  // namespace trivet
