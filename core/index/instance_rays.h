// Rays in float32 through instances of triangle meshes: for pictures, not for answers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/base/types.h"

namespace trivet {

inline constexpr int kRayLanes = 8;
inline constexpr std::uint32_t kNoFace = ~0u;

using Vec3f = Eigen::Vector3f;

/// Eight rays that are traced together. Lanes that are off are left alone.
struct RayPacket {
  alignas(32) float origin[3][kRayLanes];
  alignas(32) float direction[3][kRayLanes];
  alignas(32) float nearest[kRayLanes], farthest[kRayLanes];  // in lengths of the direction
  alignas(32) std::int32_t on[kRayLanes];                     // -1: on, 0: off

  void set(int lane, const Vec3f& from, const Vec3f& along, float near, float far) {
    for (int k = 0; k < 3; ++k) origin[k][lane] = from[k], direction[k][lane] = along[k];
    nearest[lane] = near, farthest[lane] = far, on[lane] = -1;
  }
};

struct HitPacket {
  std::uint32_t face[kRayLanes];  // of the mesh; kNoFace: none
  std::uint32_t instance[kRayLanes];
  float distance[kRayLanes];         // in lengths of the direction
  float v[kRayLanes], w[kRayLanes];  // weights of the second and third corner
  Vec3f position(const RayPacket& rays, int lane) const {
    Vec3f out;
    for (int k = 0; k < 3; ++k)
      out[k] = rays.origin[k][lane] + distance[lane] * rays.direction[k][lane];
    return out;
  }
};

/// Share of the light that a face lets through at a point, by the weights of its second and third
/// corner; of faces that are the same everywhere, 1.
using PassedAt = std::function<float(std::uint32_t face, float v, float w)>;

/// Meshes are kept once, however many instances they have. Made in three steps: meshes, instances,
/// commit(); then const and thread-safe.
class InstanceRays {
 public:
  /// @throws Error (Environment) when Embree cannot start.
  InstanceRays();
  ~InstanceRays();
  InstanceRays(const InstanceRays&) = delete;
  InstanceRays& operator=(const InstanceRays&) = delete;

  /// @param passed  #F, what of the light each face lets through, 0 to 1 by colour; empty: all 0.
  /// @param passed_at  beside it, of what varies over a face; null: nothing does. Called from all
  ///   threads.
  /// @return its number, from 0.
  std::uint32_t add_mesh(std::span<const Vec3f> vertices, std::span<const Index3> triangles,
                         std::span<const Vec3f> passed, PassedAt passed_at = nullptr);
  /// @param columns  of the affine map from the mesh: x, y, z and the translation; finite.
  std::uint32_t add_instance(std::uint32_t mesh, const std::array<Vec3f, 4>& columns);
  /// On all cores. @throws Error (Environment) when Embree lacks memory.
  void commit();

  /// Directions must be finite.
  HitPacket first_hits(const RayPacket& rays) const;
  /// Light that each ray passes on, by colour: 0 where a face that lets nothing through is in the
  /// way.
  std::array<Vec3f, kRayLanes> passed(const RayPacket& rays) const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace trivet
