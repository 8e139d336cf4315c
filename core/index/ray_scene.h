// The faces that a ray may hit. Private.
#pragma once

#include <functional>

#include "core/index/embree.h"
#include "core/mesh/mesh.h"

namespace trivet {

/// A mesh as a scene of Embree, whose boxes are grown by more than float32 loses along a ray.
class RayScene {
 public:
  /// @throws Error (Environment) when Embree lacks memory. Cost O(n log n), on all cores.
  explicit RayScene(const Mesh& mesh);

  /// @return the time after which hits do not matter any more.
  using Visit = std::function<double(Index face)>;
  /// Visits every face that the ray hits at a time >= 0, but for those later than the last time
  /// returned, and many that it misses, in any order. @param until  the first such time.
  /// Thread-safe.
  void visit(const Vec3& origin, const Vec3& direction, double until, const Visit& visit) const;

 private:
  Vec3 m_centre;
  double m_scale = 0;  // 0: no extent, or out of all proportion; all faces are visited
  Index m_num_faces = 0;
  EmbreePointer<RTCScene> m_scene;
};

}  // namespace trivet
