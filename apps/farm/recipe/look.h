// Ranges from which light, floor and camera of pictures are drawn: "look" of a recipe's views.
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

struct LookRanges {
  LightRange key, sky;
  // The key light's, degrees; none: behind the viewer, to the left.
  std::optional<Interval> elevation_deg, azimuth_deg;
  std::vector<std::string> environments;  // OpenEXR files; one is drawn for each scene
  Interval environment_strength{1, 1};
  std::optional<ColourRange> floor, background;
  Interval exposure{1, 1}, noise{0, 0};  // of each view
};

/// @throws Error (BadInput) naming the place, the value and what is accepted.
LookRanges read_look(const JsonPlace& place);

}  // namespace trivet::farm
