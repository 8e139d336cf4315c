// Height maps of bodies seen from above: what drop_brackets() correlates.
#pragma once

#include <span>

#include "core/contact/body.h"
#include "raster/drop_brackets.h"

namespace trivet {

/// Where pixels are: pixel (i, j) is the square from `corner` + (i, j) pixel on; world, metres.
struct MapGrid {
  Vec2 corner = Vec2::Zero();
  double pixel = 0;  // metres
  int width = 0, height = 0;
  double level = 0;  // heights are relative to this z

  /// Pixels that hold a box seen from above.
  static MapGrid about(const Aabb& box, double pixel, double level);
};

/// The lowest surfaces, with the bodies grown by `growth` metres in every direction.
HeightMap draw_underside(std::span<const Body> bodies, const MapGrid& grid, double growth);

/// The highest surfaces.
/// @param floor    the plane z = 0 is there, too.
/// @param ceiling  faces that are above this z as a whole are left out.
HeightMap draw_top(std::span<const Body> bodies, const MapGrid& grid, bool floor,
                   double ceiling = kInfinity);

/// The bounds of tops widened: the highest within so many pixels of each, centre to centre.
/// @param border  pixels at each side of `map` that the result does not have; >= pixels.
HeightMap widened_top(const HeightMap& map, double pixels, int border);

}  // namespace trivet
