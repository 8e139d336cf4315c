// Depth images of a motion, for display: in every pixel the fronts of the moving and of the fixed
// faces, and where the first contact may be.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/candidates/zlist_frame.h"

namespace trivet {

/// Row by row, row 0 first, as in the frame. Depths in the frame's units: pixels of a translation,
/// radians of a turn, from the rear of the moving bodies on.
struct MotionDepths {
  ZListFrame frame;                 // empty(): nothing is in the way, and there are no pixels
  std::vector<float> moving_front;  // farthest depth of the moving faces; -infinity: none
  std::vector<float> fixed_front;   // nearest depth of the fixed faces, from the rear of the moving
                                    // ones on; infinity: none
  std::vector<std::uint8_t> doubtful;  // 1: the first contact may be in this pixel
  bool complete = true;         // false: a face next to the axis of a turn has too many pieces, and
                                // neither the bounds nor `doubtful` mean anything
  double lower = kInfinity;     // no contact before this time; infinity: none within the limit
  double upper = kInfinity;     // contact by this time at the latest; infinity: perhaps none
  std::int64_t num_pixels = 0;  // with moving and fixed faces
  std::int64_t num_doubtful = 0;  // of these

  size_t size() const { return moving_front.size(); }
  bool has_moving(size_t pixel) const { return moving_front[pixel] > -kInfinity; }
  bool has_fixed(size_t pixel) const { return fixed_front[pixel] < kInfinity; }
  bool has_both(size_t pixel) const { return has_moving(pixel) && has_fixed(pixel); }
  /// Depth that the moving faces can gain before a contact in this pixel, >= 0; only if has_both().
  float gap(size_t pixel) const;
  bool turns() const { return frame.kind == Motion::Kind::Rotation; }
  /// A depth for display: millimetres of a translation, degrees of a turn.
  double shown(double depth) const;
  const char* unit() const { return turns() ? "deg" : "mm"; }
  /// The pixel on whose lines of sight a point lies; nullopt: outside the image.
  std::optional<size_t> pixel_of(const Vec3& world) const;
};

/// Stages 1 to 3 of a query [Shinya 1995, 5.1], pixel by pixel, by the rasteriser of
/// SoftwareZLists: its intervals contain all depths of a face in a pixel, and moving faces are
/// grown by the largest distance at which pairs stop. So the pixel of the first contact, on the
/// fixed body, is doubtful (README.md). The floor is left out. Cost O(vertices + faces + touched
/// pixels), one thread; re-entrant.
/// @param horizon  contacts later than this do not matter; at most query.motion.limit.
/// @param resolution  pixels along the longer side, > 0.
MotionDepths motion_depths(const FirstContactQuery& query, double horizon, int resolution);

}  // namespace trivet
