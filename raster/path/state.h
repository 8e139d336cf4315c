// A path on its way. Private.
#pragma once

#include <algorithm>

#include "raster/path/tracer.h"

namespace trivet {

inline constexpr float kMaxRadiance = 6;  // of a path after its first surface

struct PathTracer::Path {
  Sampler sampler;
  Vec3f from, direction;
  Vec3f weight = Vec3f::Ones();                 // of the light that comes back along it
  NextRay::Kind kind = NextRay::Kind::Through;  // of its last reflection
  bool on = true;
  bool has_seen = false;  // its first surface
  bool matt = false;      // its light counts as matt, without the first albedo
  bool inside = false;    // of glass
  int num_bounces = 0, num_through = 0, num_absent = 0;
  float width = 0, spread = 0;     // of the cone around it: by now, per length
  Vec3f absorbed = Vec3f::Zero();  // inside, per length
  // Light of a lamp if nothing is in the way up to it.
  bool asks_key = false, asks_first = false;
  float key_end = 0;
  Vec3f key_from, key_direction, key_matt, key_bright;
  // Values of this sample.
  float coverage = 0;
  Vec3f albedo = Vec3f::Zero(), sum_matt = Vec3f::Zero(), sum_bright = Vec3f::Zero();
  Vec3f normal = Vec3f::Zero(), position = Vec3f::Zero();

  bool is_first() const { return num_bounces == 0 && num_through == 0; }
  bool sees_background() const { return kind == NextRay::Kind::Through && num_bounces == 0; }
  /// Single paths that are much brighter than the others are held down.
  void add(const Vec3f& light) {
    const Vec3f held = num_bounces > 0 ? Vec3f(light.cwiseMin(kMaxRadiance)) : light;
    (matt ? sum_matt : sum_bright) += held;
  }
  void add_key(const Vec3f& passed) {
    if (asks_first) {
      sum_matt += key_matt.cwiseProduct(passed);
      sum_bright += key_bright.cwiseProduct(passed);
    } else {
      add((key_matt + key_bright).cwiseProduct(passed));
    }
  }
  void uncover(float share) { coverage -= share * std::clamp(weight.mean(), 0.0f, 1.0f); }
};

}  // namespace trivet
