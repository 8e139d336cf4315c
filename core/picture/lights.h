// The lights of a picture: a soft key light and a sky; for shadow maps, a few far lights per view.
#pragma once

#include <array>

#include "core/picture/frame.h"

namespace trivet {

inline constexpr double kKeyShare = 0.58;                     // of the light on an open floor
inline constexpr double kKeyRadiusDeg = 5;                    // of its disc; wider: softer shadows
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

  /// Towards the centre of the key light's disc, and the irradiance of all of it on a surface that
  /// faces it.
  const Vec3& key_direction() const { return m_key_direction; }
  Vec3 key_irradiance() const;
  /// Colour of the sky at the sine of elevation `z`: radiance.
  Vec3 sky_colour(double z) const;
  /// Radiance of the sky at the sine of elevation `z`, without its colour.
  double sky_radiance(double z) const;

 private:
  Vec3 m_key_direction;
  double m_key_scale = 1, m_sky_scale = 1;
};

/// Point `index` of an additive sequence that fills the unit square evenly. @see [Roberts 2018]
Vec2 even_point(int index);

}  // namespace trivet
