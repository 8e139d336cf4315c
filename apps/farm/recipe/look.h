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

/// Lamps of each scene, instead of the key light, or beside it where "key" is given.
struct LampRanges {
  enum class Kind { Sun, Bulb, Panel };
  std::vector<Kind> kinds{Kind::Panel};  // one is drawn for each lamp
  Counts count{1, 1};
  LightRange light;  // strength: times the studio's key light, in the middle of the scene
  Interval elevation_deg{20, 80}, azimuth_deg{0, 360};
  Interval distance{1, 2}, size{0.05, 0.5};  // metres; of a sun none, and its disc is given
};

/// A lens instead of a pinhole.
struct LensRanges {
  Interval f_number{8, 8};  // of a sensor 36 mm wide
  Interval focus{1, 1};     // times the distance to the middle of the scene
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
  std::optional<LampRanges> lamps;
  std::vector<std::string> environments;  // OpenEXR or Radiance; one is drawn for each scene
  Interval environment_strength{1, 1};
  std::optional<Interval> environment_turn_deg;  // counter-clockwise from above; none: any
  bool key_beside = false;  // "key" is given: it shines beside lamps and environments
  std::optional<ColourRange> floor, background;
  std::optional<RoomRanges> room;
  Interval exposure{1, 1}, noise{0, 0};  // of each view
  std::optional<LensRanges> lens;        // the same
};

/// @throws Error (BadInput) naming the place, the value and what is accepted.
LookRanges read_look(const JsonPlace& place);
SurfaceRanges read_surface(const JsonPlace& place);

}  // namespace trivet::farm
