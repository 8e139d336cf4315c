#include "apps/farm/recipe/look.h"

#include "apps/farm/recipe/recipe_json.h"
#include "core/base/extension.h"

namespace trivet::farm {
namespace {

constexpr int kMaxLamps = 16;

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
    const std::string kind = lower_extension(out.environments.back());
    if (kind != ".exr" && kind != ".hdr") file.refuse("OpenEXR or Radiance files: .exr or .hdr");
  }
  if (out.environments.empty()) place.refuse("an array of at least one .exr or .hdr file");
}

std::vector<std::string> read_image_files(const JsonPlace& place) {
  std::vector<std::string> out;
  for (const JsonPlace& file : place.items()) {
    out.push_back(file.text());
    const std::string kind = lower_extension(out.back());
    if (kind != ".png" && kind != ".jpg" && kind != ".jpeg" && kind != ".webp")
      file.refuse("pictures: .png, .jpg, .jpeg or .webp");
  }
  if (out.empty()) place.refuse("an array of at least one picture");
  return out;
}

LampRanges::Kind read_lamp_kind(const JsonPlace& place) {
  if (place.value() == "sun") return LampRanges::Kind::Sun;
  if (place.value() == "bulb") return LampRanges::Kind::Bulb;
  if (place.value() == "panel") return LampRanges::Kind::Panel;
  place.refuse("\"sun\", \"bulb\" or \"panel\"");
}

LampRanges read_lamps(const JsonPlace& place) {
  place.expect_object({}, {"kind", "count", "strength", "temperature", "elevation_deg",
                           "azimuth_deg", "distance", "size"});
  LampRanges out;
  if (const auto kind = place.find("kind")) {
    out.kinds.clear();
    if (kind->value().is_array())
      for (const JsonPlace& one : kind->items()) out.kinds.push_back(read_lamp_kind(one));
    else
      out.kinds.push_back(read_lamp_kind(*kind));
    if (out.kinds.empty()) kind->refuse("a kind, or an array of at least one");
  }
  out.light = read_light(place);
  if (const auto count = place.find("count")) out.count = read_counts(*count, 1, kMaxLamps);
  if (const auto deg = place.find("elevation_deg")) out.elevation_deg = read_interval(*deg, 1, 90);
  if (const auto deg = place.find("azimuth_deg")) out.azimuth_deg = read_interval(*deg, -360, 360);
  if (const auto metres = place.find("distance")) out.distance = read_interval(*metres, 1e-3, 1e3);
  if (const auto metres = place.find("size")) out.size = read_interval(*metres, 0, 1e3);
  return out;
}

LensRanges read_lens(const JsonPlace& place) {
  place.expect_object({}, {"f_number", "focus"});
  LensRanges out;
  if (const auto number = place.find("f_number")) out.f_number = read_interval(*number, 0.5, 1000);
  if (const auto focus = place.find("focus")) out.focus = read_interval(*focus, 0.01, 100);
  return out;
}

RoomRanges read_room(const JsonPlace& place) {
  place.expect_object({}, {"floor_images", "wall_images", "walls", "tile", "distance", "height"});
  RoomRanges out;
  if (const auto files = place.find("floor_images")) out.floor_images = read_image_files(*files);
  if (const auto files = place.find("wall_images")) out.wall_images = read_image_files(*files);
  if (const auto walls = place.find("walls")) out.walls = read_colours(*walls);
  if (const auto tile = place.find("tile")) out.tile = read_interval(*tile, 1e-3, 1e3);
  if (const auto metres = place.find("distance")) out.distance = read_interval(*metres, 0, 1e3);
  if (const auto metres = place.find("height")) out.height = read_interval(*metres, 1e-3, 1e3);
  return out;
}

}  // namespace

SurfaceRanges read_surface(const JsonPlace& place) {
  place.expect_object({}, {"roughness", "metallic", "colour"});
  SurfaceRanges out;
  if (const auto range = place.find("roughness")) out.roughness = read_interval(*range, 0, 1);
  if (const auto range = place.find("metallic")) out.metallic = read_interval(*range, 0, 1);
  if (const auto range = place.find("colour")) out.colour = read_colours(*range);
  return out;
}

LookRanges read_look(const JsonPlace& place) {
  place.expect_object({},
                      {"key", "lamps", "sky", "environments", "environment_strength", "floor",
                       "environment_turn_deg", "background", "room", "exposure", "noise", "lens"});
  LookRanges out;
  if (const auto lamps = place.find("lamps")) out.lamps = read_lamps(*lamps);
  if (const auto lens = place.find("lens")) out.lens = read_lens(*lens);
  if (const auto key = place.find("key")) {
    key->expect_object({}, {"strength", "temperature", "elevation_deg", "azimuth_deg"});
    out.key_beside = true;
    out.key = read_light(*key);
    if (const auto deg = key->find("elevation_deg")) out.elevation_deg = read_interval(*deg, 1, 90);
    if (const auto deg = key->find("azimuth_deg")) out.azimuth_deg = read_interval(*deg, -360, 360);
  }
  if (const auto sky = place.find("sky")) {
    sky->expect_object({}, {"strength", "temperature"});
    out.sky = read_light(*sky);
  }
  if (const auto files = place.find("environments")) read_environments(*files, out);
  const auto of_environments = [&](const char* name) {
    auto given = place.find(name);
    if (given && out.environments.empty()) given->fail("there is no \"environments\" for it");
    return given;
  };
  if (const auto strength = of_environments("environment_strength"))
    out.environment_strength = read_interval(*strength, 0, 1000);
  if (const auto deg = of_environments("environment_turn_deg"))
    out.environment_turn_deg = read_interval(*deg, -360, 360);
  if (const auto floor = place.find("floor")) out.floor = read_colours(*floor);
  if (const auto background = place.find("background")) out.background = read_colours(*background);
  if (const auto room = place.find("room")) out.room = read_room(*room);
  if (const auto exposure = place.find("exposure"))
    out.exposure = read_interval(*exposure, 0, 1000);
  if (const auto noise = place.find("noise")) out.noise = read_interval(*noise, 0, 1);
  return out;
}

}  // namespace trivet::farm
