// Faces on the lines of sight through the centres of pixels.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "raster/zlist/projection.h"

namespace trivet {

/// A face that certainly meets a line.
struct FaceOnLine {
  std::uint32_t pixel;       // row * width + column, rows from the bottom
  std::uint32_t body, face;  // index into the span; triangle of its mesh
  float depth;               // pixels from Projection::nearest, to 0.02
};

/// Calls met() for what CompleteZLists have at the centres of pixels, in the order of bodies and
/// their faces: half the drawing, no sorting and no memory, for readers that need no order of
/// depth.
void for_each_face_on_lines(std::span<const Body> bodies, const Projection& projection,
                            const std::function<void(const FaceOnLine&)>& met);

}  // namespace trivet
