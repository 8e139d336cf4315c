// Private to gpu: the lights of a picture, a few per view, and their shadow maps.
#pragma once

#include <array>
#include <span>

#include "gpu/picture/picture_frame.h"

namespace trivet {

inline constexpr double kKeyShare = 0.58;                     // of the light on an open floor
inline constexpr int kNumSkyLights = 3, kNumFloorLights = 2;  // per view, beside the key light
inline constexpr int kLightsPerView = 1 + kNumSkyLights + kNumFloorLights;

/// A directional light.
struct PictureLight {
  Vec3 direction = Vec3::UnitZ();  // towards the light, unit
  Vec3 irradiance = Vec3::Zero();  // on a surface that faces it, RGB
};

/// The lights of one sub-pixel view. Averaged over all views they form a soft key light, a sky that
/// brightens towards the zenith, and the light reflected by the floor. A floor of albedo 1 in the
/// open has radiance 1 from key and sky together.
class PictureLights {
 public:
  /// Normalised so that the number of views does not affect brightness.
  PictureLights(int num_views, const FrameCamera& camera);

  /// [0] key, [1..3] sky, [4..5] from below: their irradiance is for a floor of albedo 1 in the
  /// open.
  std::array<PictureLight, kLightsPerView> of_view(int view) const;

  /// Radiance of the sky at the sine of elevation `z`, without its colour.
  double sky_radiance(double z) const;

 private:
  Vec3 m_key_direction;
  double m_key_scale = 1, m_sky_scale = 1;
};

/// Orthographic depth image of all casters from a light. Jittered by a fraction of a texel from
/// view to view, so that texel outlines average out.
struct ShadowMap {
  Eigen::Matrix4f clip_from_frame;
  double texel = 0;  // side of a texel, frame
};

ShadowMap fit_shadow_map(const Vec3& direction, std::span<const Vec3> hull_points, int size_px,
                         const Vec2& jitter_px);

/// Point `index` of an additive sequence that fills the unit square evenly. @see [Roberts 2018]
Vec2 even_point(int index);

}  // namespace trivet
