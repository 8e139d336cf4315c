// Texels at surface points: trilinear look-ups in the copies of an image. Private.
#pragma once

#include "core/index/instance_rays.h"
#include "core/io/textures/surface_look.h"

namespace trivet {

/// Coordinates at which a texture is looked up.
Eigen::Vector2f texture_position(const TextureUse& use, const Eigen::Vector2f& coordinates);

/// Red, green, blue and alpha at a position, linear if the image holds colours.
/// @param texels_across  width of what the look-up covers, texels of the finest level; at most 1:
///   the finest level alone.
Eigen::Vector4f looked_up(const TextureImage& image, const TextureUse& use,
                          const Eigen::Vector2f& position, float texels_across);

/// Surface of a face as seen at one point.
struct FacePoint {
  std::size_t face;
  std::array<float, 3> weights;  // of the corners
  float width = 0;  // of what look-ups cover, relative to the root of twice the face's area
};

/// Looks of faces: what their textures and colours give, factors of materials included.
class FaceLook {
 public:
  FaceLook(const SurfaceLook& look, const FacePoint& at);

  /// Linear RGB and alpha, of the material, the corners' colours and the texture.
  Eigen::Vector4f base_colour() const;
  /// Alpha of the same, after the cutoff of materials that have one.
  float alpha() const { return kept(base_colour()[3]); }
  /// Share that is there, of that alpha.
  float kept(float alpha) const;
  struct Polish {
    float metallic, roughness;
  };
  Polish polish() const;
  Vec3f emitted() const;
  /// To the right, up and off the surface as seen in the image of normals; unit.
  Vec3f mapped_normal() const;
  const SurfaceFinish& finish() const { return m_finish; }
  /// Tangent of SurfaceLook::tangents.
  const Eigen::Vector4f& tangent() const { return m_look.tangents[m_at.face]; }

 private:
  Eigen::Vector4f lookup(const TextureUse& use) const;

  const SurfaceLook& m_look;
  const FacePoint& m_at;
  const Material& m_material;
  const SurfaceFinish& m_finish;
};

}  // namespace trivet
