// Surfaces that dip below a plane, which then is not the plane of a contact. Private.
#pragma once

#include "core/base/tunables.h"
#include "core/contact/body.h"
#include "core/contact/rounding.h"

namespace trivet {

inline bool dips(const Vec3& d, const Vec3& up) { return up.dot(d) < -kConeSlope * d.norm(); }

/// A neighbour of the vertex, which is at p, lies below the plane through p.
inline bool vertex_dips(const Body& body, Index vertex, const Vec3& p, const Vec3& up) {
  for (const Index edge : body.shape->adjacency.vertex_edges[vertex]) {
    const auto& ends = body.shape->adjacency.edge_vertices[edge];
    if (dips(body.vertex(ends[0] == vertex ? ends[1] : ends[0]) - p, up)) return true;
  }
  return false;
}

/// A face at the edge goes below the plane through p, which is on the edge.
inline bool edge_dips(const Body& body, Index edge, const Vec3& p, const Vec3& up) {
  // The way from p to an end of the edge that it is at is rounding, and has no direction.
  const double rounding = kRounding * p.cwiseAbs().maxCoeff();
  for (const Wing& wing : body.shape->adjacency.edge_faces[edge])
    for (const Index vertex : body.shape->mesh.triangles[wing.face]) {
      const Vec3 d = body.vertex(vertex) - p;
      if (dips(d, up) && up.dot(d) < -rounding) return true;
    }
  return false;
}

/// The same where p may be an end of the edge: within `slack` of one, that vertex must not dip
/// either. A diagonal of a flat side goes below no plane of that side, but the body does where the
/// diagonal ends.
inline bool edge_dips_near_ends(const Body& body, Index edge, const Vec3& p, const Vec3& up,
                                double slack) {
  if (edge_dips(body, edge, p, up)) return true;
  for (const Index vertex : body.shape->adjacency.edge_vertices[edge]) {
    const Vec3 end = body.vertex(vertex);
    if ((end - p).squaredNorm() <= slack * slack && vertex_dips(body, vertex, end, up)) return true;
  }
  return false;
}

}  // namespace trivet
