// z-lists [Shinya 1995, 2]: for every pixel along a direction, all faces on its lines of sight.
#pragma once

#include "trivet/scene.h"

TRIVET_BEGIN

struct ZListOptions {
  Vec3 direction{0, 0, -1};  // of sight, of any length but zero
  int resolution = 256;      // pixels along the longer side, 1 to 8192
};

/// A face in a pixel; depths in metres along the direction, from the world's origin.
struct ZListItem {
  std::int32_t object = 0, face = 0;  // index into ZLists::objects; triangle of its mesh
  double nearest = 0, farthest = 0;   // contain all depths of the face within the pixel
};

struct ZLists {
  int width = 0, height = 0;
  double pixel = 0;                  // metres
  Vec3 right, up, direction;         // unit
  Vec2 corner;                       // metres along right and up: of pixel (0, 0), below left
  std::vector<std::string> objects;  // names
  std::vector<std::int64_t> start;   // of each pixel's items, row by row from below, and the end
  std::vector<ZListItem> items;      // of a pixel: nearest first
};
/// Lists are conservative: a face is in the list of every pixel that it touches.
/// @throws Error (BadInput) for options out of range.
[[nodiscard]] TRIVET_API ZLists z_lists(const Scene& scene, const ZListOptions& options = {});

TRIVET_END
