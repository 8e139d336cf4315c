// Height maps of bodies seen from above, the input of drop_brackets().
#pragma once

#include <span>

#include "core/contact/body.h"
#include "raster/height_map/drop_brackets.h"

namespace trivet {

/// Placement of pixels: pixel (i, j) is the square from `corner` + (i, j) pixel on; world, metres.
struct MapGrid {
  Vec2 corner = Vec2::Zero();
  double pixel = 0;  // metres
  int width = 0, height = 0;
  double level = 0;  // heights are relative to this z

  /// Pixels that contain a box seen from above.
  static MapGrid about(const Aabb& box, double pixel, double level);
};

/// The lowest surfaces, with the bodies grown by `growth` metres in every direction.
HeightMap draw_underside(std::span<const Body> bodies, const MapGrid& grid, double growth);

enum class MapParts { All, Bounds };

/// The highest surfaces.
/// @param floor    include the plane z = 0.
/// @param ceiling  skip faces wholly above this z.
/// @param parts    Bounds: the map has no samples, which takes less time.
HeightMap draw_top(std::span<const Body> bodies, const MapGrid& grid, bool floor,
                   double ceiling = kInfinity, MapParts parts = MapParts::All);

/// Widened upper bounds: the maximum within so many pixels of each, centre to centre.
/// @param border  pixels cropped from each side of `map`; >= pixels.
HeightMap widened_top(const HeightMap& map, double pixels, int border);

}  // namespace trivet
