// Values of meshes that renderers cannot trust as they are. Private.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/picture/scene.h"

namespace trivet {

/// Texels of all textures of a scene together. The nearer it is, the smaller are further textures.
inline constexpr std::size_t kMaxSceneTextureBytes = std::size_t{1} << 30;

/// Bytes that a mesh may take beside those that have taken `used_bytes`: a quarter of the rest.
inline std::size_t texture_bytes_left(std::size_t used_bytes) {
  return std::min(kMaxTextureBytes,
                  (kMaxSceneTextureBytes - std::min(used_bytes, kMaxSceneTextureBytes)) / 4);
}

/// A mesh with its look, if it has one: materials and faces are those that are drawn.
struct DrawnMesh : PictureMesh {
  DrawnMesh(const PictureMesh& mesh, std::size_t max_texture_bytes)
      : PictureMesh(mesh), surface(mesh.look ? mesh.look(max_texture_bytes) : nullptr) {
    if (!surface) return;
    materials = surface->materials;
    face_material = surface->face_material;
  }
  /// True if the look has more than materials.
  bool has_details() const { return surface && !surface->finishes.empty(); }

  std::shared_ptr<const SurfaceLook> surface;
};

/// Held between 0 and 1.
inline float unit_or(float value, float otherwise) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

/// Index of a face's material; 0 where there is none.
inline std::uint32_t material_of(const PictureMesh& mesh, std::size_t face) {
  if (face >= mesh.face_material.size() || mesh.materials.empty()) return 0;
  const auto last = static_cast<Index>(mesh.materials.size() - 1);
  return static_cast<std::uint32_t>(std::clamp(mesh.face_material[face], 0, last));
}

inline Aabb finite_box(const PictureMesh& mesh) {
  Aabb box;
  for (const Vec3& v : mesh.vertices)
    if (v.allFinite()) box.extend(v);
  return box;
}

/// The inverse transpose up to a factor, which exists for singular matrices too.
inline Mat3 cofactors(const Mat3& m) {
  Mat3 out;
  for (int i = 0; i < 3; ++i) out.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
  const double largest = out.cwiseAbs().maxCoeff();
  return largest > 0 ? Mat3(out / largest) : Mat3::Identity();
}

}  // namespace trivet
