// Light at surfaces: what they reflect, and where rays go on. Private.
#pragma once

#include <optional>

#include "raster/path/sampler.h"
#include "raster/path/scene.h"

namespace trivet {

/// Light by way of the diffuse reflection, without the albedo, and by the mirroring one.
struct Reflected {
  float matt = 0;
  Vec3f bright = Vec3f::Zero();
};

/// Share of the irradiance from a far light that goes to the eye; both directions unit, away from
/// the surface. GGX with Smith's masking in Hammon's approximation and Schlick's Fresnel term.
Reflected reflected(const SurfacePoint& at, const Vec3f& to_light, const Vec3f& to_eye);

inline Vec3f diffuse_albedo(const PathMaterial& m) { return m.base * (1 - m.metallic); }

/// Off the face, so that a ray does not meet it again.
Vec3f lifted(const SurfacePoint& at, const Vec3f& direction);

/// Continuation of a path.
struct NextRay {
  enum class Kind { Matt, Bright, Through };
  Kind kind;
  Vec3f from, direction;  // unit
  Vec3f weight;           // of the light from there; of Matt without the albedo
  bool enters = false;    // glass
};

/// nullopt: the path ends. @param choice  between kinds. @param at_random  within one.
std::optional<NextRay> next_ray(const SurfacePoint& at, const Vec3f& to_eye, Sampler::Pair choice,
                                Sampler::Pair at_random);

/// Unit vectors that make a frame with n. @see [Duff 2017]
struct Tangents {
  Vec3f x, y;
};
Tangents tangents(const Vec3f& n);

}  // namespace trivet
