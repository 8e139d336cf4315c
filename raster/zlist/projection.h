// Lines of sight through the pixels of an image of static bodies, and where it is.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/candidates/zlist_frame.h"
#include "core/contact/body.h"

namespace trivet {

/// A rectangle of the image, metres along Projection::right and Projection::up from the world's
/// origin.
struct ImageRegion {
  Vec2 lower, upper;
};

struct ProjectionOptions {
  Vec3 direction = -Vec3::UnitZ();                // of sight, away from the eye; any length but 0
  int resolution = 256;                           // pixels along the longer side, 1 to 8192
  std::optional<ImageRegion> region;              // nullopt: everything the bodies cover
  std::size_t most_bytes = std::size_t{1} << 30;  // of the lists
  int num_threads = 1;                            // 0: all cores; results do not depend on it
};

/// Placement of pixels. Orthogonal; pixel (i, j), j from the bottom, is the square starting at
/// corner + pixel (i, j).
struct Projection {
  Vec3 right, up, direction;   // unit; up is as close to the world's z as possible, else its y
  Vec2 corner = Vec2::Zero();  // metres, as of ImageRegion
  double nearest = 0;          // depth of ZListItem 0, metres
  double pixel = 0;            // metres
  int width = 0, height = 0;

  /// Distance along `direction` from the plane through the world's origin; metres.
  double depth(float of_item) const { return nearest + pixel * of_item; }
};

/// The image of these bodies. Empty, of width 0, if they have no vertices.
/// @throws Error (BadInput) for options out of range.
Projection projection_of(std::span<const Body> bodies, const ProjectionOptions& options);

/// The frame of the same image; depth 0 is `nearest`.
ZListFrame frame_of(const Projection& projection);

}  // namespace trivet
