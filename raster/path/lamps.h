// Lamps of a picture, in the picture frame. Private.
#pragma once

#include <vector>

#include "core/picture/frame.h"
#include "core/picture/lights.h"
#include "raster/path/picture.h"
#include "raster/path/sampler.h"
#include "raster/path/surface_light.h"

namespace trivet {

/// Light towards a point: one ray to it, drawn among all lamps in proportion to their strength.
struct LampLight {
  Vec3f direction;   // towards the lamp, unit
  float distance;    // to it; beyond, nothing hides it
  Vec3f irradiance;  // on a surface that faces it, over the chance that it was drawn
};

class Lamps {
 public:
  /// The look's lamps, and the studio's key light where there is no other light or it is beside.
  Lamps(const PictureLook& look, const PictureLights& lights, const PictureFrame& frame);

  /// On a surface that faces each, in the middle of the scene; 0: an environment lights alone.
  float irradiance() const { return m_irradiance; }
  /// @param point  picture frame. @param u  of one ray. Not without lamps.
  LampLight towards(const Vec3f& point, Sampler::Pair u) const;

 private:
  struct Lamp {
    PictureLamp::Kind kind;
    Vec3f at;      // its middle; of a sun the direction towards it
    Vec3f facing;  // from the middle of the scene towards it, unit
    Tangents side;
    float radius, distance;       // of a sun the radius is a tangent
    Vec3f irradiance;             // in the middle of the scene
    float share = 1, before = 0;  // of the chance
  };
  static Lamp key_lamp(const PictureLook& look, const PictureLights& lights);
  static Lamp look_lamp(const PictureLamp& lamp, double key, const PictureFrame& frame);
  void share_out();
  static LampLight light_of(const Lamp& lamp, const Vec3f& point, Sampler::Pair u);

  std::vector<Lamp> m_lamps;
  float m_irradiance = 0;  // luminance of the sum
};

}  // namespace trivet
