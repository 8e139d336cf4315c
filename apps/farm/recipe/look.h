// Ranges from which light, surroundings, surfaces and cameras of pictures are drawn: "look" of a
// recipe's views and groups.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/farm/recipe/decisions.h"
#include "ops/files/json/text.h"

namespace trivet::farm {

struct LightRange {
  Interval strength{1, 1};              // times the studio's
  std::optional<Interval> temperature;  // kelvin; none: the studio's colour
};

struct ColourRange {
  Vec3 low, high;  // sRGB, 0 to 1
};

/// Floor and four walls around all cameras; nothing above, where light comes in.
struct RoomRanges {
  std::vector<std::string> floor_images, wall_images;  // one of each is drawn for each scene
  std::optional<ColourRange> walls;           // times the image; none: light grey, or white
  Interval tile{1, 1};                        // metres that an image is wide
  Interval distance{2, 3}, height{2.5, 2.5};  // metres: from the middle to the walls, and of them
};

/// Surfaces of a group's objects, drawn for each; what is not given stays that of the model.
struct SurfaceRanges {
  std::optional<Interval> roughness, metallic;
  std::optional<ColourRange> colour;  // times the model's
};

struct LookRanges {
  LightRange key, sky;
  // The key light's, degrees; none: behind the viewer, to the left.
  std::optional<Interval> elevation_deg, azimuth_deg;
  std::vector<std::string> environments;  // OpenEXR files; one is drawn for each scene
  Interval environment_strength{1, 1};
  std::optional<ColourRange> floor, background;
  std::optional<RoomRanges> room;
  Interval exposure{1, 1}, noise{0, 0};  // of each view
};

/// @throws Error (BadInput) naming the place, the value and what is accepted.
LookRanges read_look(const JsonPlace& place);
SurfaceRanges read_surface(const JsonPlace& place);

}  // namespace trivet::farm
