// Sums of the light that rays bring to each pixel, and the guides of the filter. Private.
#pragma once

#include <vector>

#include "core/index/instance_rays.h"

namespace trivet {

/// Sums of one pixel, over its samples. "Matt" is light by way of the diffuse reflection of what is
/// seen first, "bright" all other.
struct PixelSums {
  Vec3f matt = Vec3f::Zero(), bright = Vec3f::Zero();  // radiance
  Vec3f albedo = Vec3f::Zero();                        // of the diffuse reflection
  Vec3f normal = Vec3f::Zero(), position = Vec3f::Zero();
  float coverage = 0;      // share of the pixel that is not background
  float seen = 0;          // share with normal and position
  float squared_matt = 0;  // of samples' luminance, where albedo is divided out
  float squared_bright = 0;
};

inline float luminance(const Vec3f& c) {
  return 0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z();
}

/// Rows from above.
struct SumImage {
  int width = 0, height = 0, samples = 1;
  std::vector<PixelSums> pixels;
};

}  // namespace trivet
