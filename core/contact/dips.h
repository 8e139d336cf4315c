// Surfaces that dip below a plane, which then is not the plane of a contact. Private.
#pragma once

#include "core/base/tunables.h"
#include "core/contact/body.h"

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
  for (const Wing& wing : body.shape->adjacency.edge_faces[edge])
    for (const Index vertex : body.shape->mesh.triangles[wing.face])
      if (dips(body.vertex(vertex) - p, up)) return true;
  return false;
}

}  // namespace trivet
