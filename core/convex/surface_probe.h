// Convex parts that stand out of the mesh for which they collide.
#pragma once

#include <vector>

#include "core/convex/parts.h"
#include "core/index/bvh.h"

namespace trivet {

struct StandsOut {
  double distance = 0;     // of the point from the mesh; 0: nothing stands out
  Vec3 at = Vec3::Zero();  // on a part
};

/// A mesh with which parts are compared.
class SurfaceProbe {
 public:
  /// @param mesh  outlives this. @param adjacency  of the same faces.
  SurfaceProbe(const Mesh& mesh, const Adjacency& adjacency);

  /// The point of the part's faces that is outside of the mesh and farthest from it, if it is
  /// farther than `known`; else `known`. Open components have no inside. Sampled: points of a face
  /// lie at most a twelfth of the part's size apart.
  /// Cost: a query of the tree for each sample, most of which end at the first near face.
  StandsOut farthest(const ConvexPart& part, const StandsOut& known = {}) const;

 private:
  StandsOut farther(const Vec3& point, const StandsOut& known) const;
  double squared_distance(const Vec3& point, double enough) const;
  bool is_inside(const Vec3& point) const;

  const Mesh& m_mesh;
  Bvh m_bvh;
  std::vector<bool> m_is_closed;  // faces of balanced components
};

/// Squared distance of a point from a closed triangle; degenerate triangles are their edges.
double squared_distance(const Vec3& point, const Triangle& triangle);

}  // namespace trivet
