// The distance of two triangles, and where it is.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// Closest points of two closed triangles. Degenerate triangles are their edges.
struct ClosestPoints {
  enum class Features {
    VertexFace,  // vertex `a` over the inside of the second triangle
    FaceVertex,  // vertex `b` over the inside of the first
    EdgeEdge,    // inside edges `a` and `b` (edge k runs from corner k to corner k + 1)
    Other,       // an end of an edge
    Crossing,    // the triangles cross: distance 0, points mean nothing
  };
  double distance = kInfinity;
  Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();
  Features features = Features::Other;
  int a = 0, b = 0;
};

/// Double precision, error about 1e-15 of the coordinates' spread. Crossing is decided in floating
/// point too: certify with triangles_intersect() where it matters.
ClosestPoints closest_points(const Triangle& a, const Triangle& b);

/// Closest points of two segments p + s u and q + t v, s and t in [0, 1].
struct SegmentPoints {
  double s, t, squared_distance;
};
SegmentPoints closest_on_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v);

}  // namespace trivet
