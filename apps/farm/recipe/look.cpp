#include "apps/farm/recipe/look.h"

#include "apps/farm/recipe/recipe_json.h"
#include "core/base/extension.h"

namespace trivet::farm {
namespace {

LightRange read_light(const JsonPlace& place) {
  LightRange out;
  if (const auto strength = place.find("strength"))
    out.strength = read_interval(*strength, 0, 1000);
  if (const auto kelvin = place.find("temperature"))
    out.temperature = read_interval(*kelvin, 1500, 15000);
  return out;
}

Vec3 read_colour(const JsonPlace& place) {
  const std::vector<double> c = place.numbers(3, 0, 1);
  return {c[0], c[1], c[2]};
}

ColourRange read_colours(const JsonPlace& place) {
  const std::vector<JsonPlace> ends = place.items();
  if (ends.size() == 3 && ends[0].value().is_number())
    return {read_colour(place), read_colour(place)};
  if (ends.size() != 2) place.refuse("[red, green, blue] of 0 to 1, or two of them: from and to");
  return {read_colour(ends[0]), read_colour(ends[1])};
}

void read_environments(const JsonPlace& place, LookRanges& out) {
  for (const JsonPlace& file : place.items()) {
    out.environments.push_back(file.text());
    if (lower_extension(out.environments.back()) != ".exr") file.refuse("OpenEXR files: .exr");
  }
  if (out.environments.empty()) place.refuse("an array of at least one .exr file");
}

}  // namespace

LookRanges read_look(const JsonPlace& place) {
  place.expect_object({}, {"key", "sky", "environments", "environment_strength", "floor",
                           "background", "exposure", "noise"});
  LookRanges out;
  if (const auto key = place.find("key")) {
    key->expect_object({}, {"strength", "temperature", "elevation_deg", "azimuth_deg"});
    out.key = read_light(*key);
    if (const auto deg = key->find("elevation_deg")) out.elevation_deg = read_interval(*deg, 1, 90);
    if (const auto deg = key->find("azimuth_deg")) out.azimuth_deg = read_interval(*deg, -360, 360);
  }
  if (const auto sky = place.find("sky")) {
    sky->expect_object({}, {"strength", "temperature"});
    out.sky = read_light(*sky);
  }
  if (const auto files = place.find("environments")) read_environments(*files, out);
  if (const auto strength = place.find("environment_strength")) {
    if (out.environments.empty()) strength->fail("there is no \"environments\" for it");
    out.environment_strength = read_interval(*strength, 0, 1000);
  }
  if (const auto floor = place.find("floor")) out.floor = read_colours(*floor);
  if (const auto background = place.find("background")) out.background = read_colours(*background);
  if (const auto exposure = place.find("exposure"))
    out.exposure = read_interval(*exposure, 0, 1000);
  if (const auto noise = place.find("noise")) out.noise = read_interval(*noise, 0, 1);
  return out;
}

}  // namespace trivet::farm
