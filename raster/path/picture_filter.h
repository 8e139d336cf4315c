// Removes what noise a few paths per pixel leave. Private.
#pragma once

#include "raster/path/sums.h"

namespace trivet {

/// Mean radiance over the pixel, not divided by its coverage, and coverage.
struct Radiance {
  Vec3f colour = Vec3f::Zero();
  float coverage = 0;
};

/// The means as they are.
std::vector<Radiance> unfiltered(const SumImage& image);

/// Means over neighbours that are alike: matt light without its albedo, and bright light, each by
/// four passes of a 3 x 3 kernel whose holes grow, weighted by normals, distance from the tangent
/// plane and the difference of brightness relative to its standard deviation. What a pixel's
/// samples differ among themselves widens its tolerance, so that pixels on outlines find
/// neighbours.
/// @see [Dammertz 2010], [Schied 2017]
std::vector<Radiance> filtered(const SumImage& image);

}  // namespace trivet
