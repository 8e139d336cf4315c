#include "apps/farm/recipe/recipe_json.h"

#include <cmath>

#include "apps/farm/recipe/set_labels.h"
#include "core/base/limits.h"
#include "core/flex/presets.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operations.h"
#include "ops/files/layout/label_keys.h"

namespace trivet::farm {
namespace {

bool is_integer(const nlohmann::json& value, int lower, int upper) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  return lower <= number && number <= upper && number == std::floor(number);
}

std::string read_plain_name(const JsonPlace& place) {
  std::string name = place.text();
  if (name == "floor") place.refuse("any name but \"floor\", which is the floor");
  return name;
}

// A number is that of the material; of [low, high] each object draws its own.
void read_material_value(const JsonPlace& place, const char* key, double lower, double upper,
                         double& value, std::optional<Interval>& range) {
  const auto found = place.find(key);
  if (!found) return;
  const Interval read = read_interval(*found, lower, upper);
  value = read.low;
  if (read.low < read.high) range = read;
}

PhysicsMaterial read_material_ranges(const JsonPlace& place, PhysicsRanges& ranges) {
  if (!place.value().is_object()) return read_material(place);
  place.expect_object({}, {"friction", "density", "restitution"});
  PhysicsMaterial out;
  const auto read = [&](const char* key, double lower, double upper, double& value,
                        std::optional<Interval>& range) {
    read_material_value(place, key, lower, upper, value, range);
  };
  read("friction", kMinFriction, kMaxFriction, out.friction, ranges.friction);
  read("density", kMinDensity, kMaxDensity, out.density, ranges.density);
  read("restitution", 0, kMaxRestitution, out.restitution, ranges.restitution);
  return out;
}

void read_mass_range(const JsonPlace& place, RecipeModel& out) {
  if (place.value().is_array())
    out.physics.kilograms = read_interval(place, kMinMass, kMaxMass);
  else
    out.object.mass = read_mass(place);
}

/// Reads what a model has of a layout's object by the layout's reader: the same keys, ranges and
/// messages.
RecipeModel read_model_entry(const JsonPlace& place) {
  place.expect_object({"model"}, {"weight", "scale", "up", "material", "chord", "facet_angle_deg",
                                  "class", "attributes", "id", "symmetries", "mass", "collision"});
  RecipeModel out;
  LayoutObject& object = out.object;
  object.model = place.at("model").text();
  if (const auto collision = place.find("collision")) object.collision = collision->text();
  if (const auto weight = place.find("weight")) out.weight = weight->number(1e-9, 1e9);
  if (const auto scale = place.find("scale")) object.scale = scale->number(kMinScale, kMaxScale);
  if (const auto up = place.find("up")) object.up = read_up(*up);
  if (const auto material = place.find("material"))
    object.material = read_material_ranges(*material, out.physics);
  if (const auto mass = place.find("mass")) read_mass_range(*mass, out);
  object.tessellation = read_tessellation(place, object.model);
  read_labels(place, object);
  read_set_keys(place, out);
  return out;
}

std::vector<std::string> read_names(const JsonPlace& place) {
  if (place.value().is_string()) return {place.text()};
  std::vector<std::string> out;
  for (const JsonPlace& item : place.items()) out.push_back(item.text());
  if (out.empty()) place.refuse("a name, or an array of at least one");
  return out;
}

PutOn read_on(const JsonPlace& place) {
  PutOn out;
  out.on = read_names(place.at("on"));
  if (const auto keep = place.find("keep")) out.keep = keep->number(0, kMaxLength);
  if (const auto region = place.find("region")) out.region = read_region(*region);
  if (const auto frame = place.find("region_of")) {
    out.region_of_support = frame->value() == "support";
    if (!out.region_of_support && frame->value() != "world")
      frame->refuse("\"world\" or \"support\"");
  }
  return out;
}

PutIn read_in(const JsonPlace& place) {
  PutIn out{read_names(place.at("in"))};
  for (const std::string& name : out.in)
    if (name == "floor") place.at("in").refuse("objects or groups; the floor has no inside");
  if (const auto above = place.find("above")) out.above = above->number(0, kMaxLength);
  return out;
}

PutHeap read_heap(const JsonPlace& place) {
  place.expect_object({"radius", "height"}, {"centre", "rise"});
  PutHeap out;
  out.radius = place.at("radius").number(0, kMaxLength);
  out.height = place.at("height").number(-kMaxLength, kMaxLength);
  if (const auto rise = place.find("rise")) out.rise = rise->number(0, kMaxLength);
  if (const auto centre = place.find("centre")) {
    const std::vector<double> c = centre->numbers(2, -kMaxLength, kMaxLength);
    out.centre = {c[0], c[1]};
  }
  return out;
}

PlaceRule read_place_rule(const JsonPlace& place) {
  const int num_ways =
      (place.find("on") ? 1 : 0) + (place.find("in") ? 1 : 0) + (place.find("heap") ? 1 : 0);
  if (num_ways != 1)
    place.fail(
        say("%1 of the keys \"on\", \"in\" and \"heap\"; accepted: exactly one, which says where",
            num_ways));
  const auto only_with = [&](const char* key, const char* other) {
    if (place.find(key) && !place.find(other))
      place.at(key).fail(say("there is no \"%1\" for it", other));
  };
  only_with("keep", "on");
  only_with("region", "on");
  only_with("region_of", "region");
  only_with("above", "in");
  if (place.find("tries") && place.find("on"))
    place.at("tries").fail(
        "no start is tried where there is room; accepted: with \"in\" or \"heap\"");
  if (place.find("on")) return read_on(place);
  if (place.find("in")) return read_in(place);
  return read_heap(place.at("heap"));
}

void read_rotation_rule(const JsonPlace& place, RecipeGroup& group) {
  if (place.value() == "yaw") return;
  if (place.value() == "any") {
    group.rotation = RotationRule::Any;
    return;
  }
  if (!place.value().is_array()) place.refuse("\"yaw\", \"any\" or a quaternion [w, x, y, z]");
  const std::vector<double> q = place.numbers(4, -kMaxQuaternionComponent, kMaxQuaternionComponent);
  const auto rotation = unit_rotation({q[0], q[1], q[2], q[3]});
  if (!rotation) place.refuse("a quaternion [w, x, y, z] whose length is not zero");
  group.rotation = RotationRule::Given;
  group.given = *rotation;
}

// Names of the materials of sheets.
std::string sheet_materials() {
  std::string out;
  for (const flex::FlexPreset& preset : flex::flex_presets())
    if (!preset.is_cable) out += (out.empty() ? "" : ", ") + preset.material.name;
  return out;
}

RecipeMove read_drape(const JsonPlace& place) {
  place.expect_object({"op", "group", "name", "size"}, {"material", "cell"});
  RecipeMove out;
  out.kind = RecipeMove::Kind::Drape;
  out.sheet.object = read_plain_name(place.at("name"));
  const std::vector<double> size = place.at("size").numbers(2, 1e-3, 1e3);
  out.sheet.size = Vec2(size[0], size[1]);
  if (const auto cell = place.find("cell")) out.sheet.cell = cell->number(1e-4, 1e3);
  if (const auto material = place.find("material")) {
    const flex::FlexPreset* const preset = flex::flex_preset(material->text());
    if (!preset || preset->is_cable) material->refuse(sheet_materials());
    out.sheet.material = material->text();
  }
  return out;
}

}  // namespace

int read_integer(const JsonPlace& place, int lower, int upper) {
  if (!is_integer(place.value(), lower, upper))
    place.refuse(say("a whole number from %1 to %2", lower, upper));
  return static_cast<int>(place.value().get<double>());
}

Interval read_interval(const JsonPlace& place, double lower, double upper) {
  if (!place.value().is_array()) {
    const double both = place.number(lower, upper);
    return {both, both};
  }
  const std::vector<double> ends = place.numbers(2, lower, upper);
  if (ends[0] > ends[1]) place.refuse("[low, high] with low <= high");
  return {ends[0], ends[1]};
}

Counts read_counts(const JsonPlace& place, int lower, int upper) {
  if (!place.value().is_array()) {
    const int both = read_integer(place, lower, upper);
    return {both, both};
  }
  const std::vector<JsonPlace> ends = place.items();
  if (ends.size() != 2) place.refuse("a whole number, or [low, high]");
  const Counts out{read_integer(ends[0], lower, upper), read_integer(ends[1], lower, upper)};
  if (out.low > out.high) place.refuse("[low, high] with low <= high");
  return out;
}

RecipeGroup read_group(const JsonPlace& place) {
  place.expect_object({"name", "models"},
                      {"count", "scale_range", "rotation", "on", "keep", "region", "region_of",
                       "in", "above", "heap", "tries", "target", "look"});
  RecipeGroup group;
  group.name = read_plain_name(place.at("name"));
  for (const JsonPlace& item : place.at("models").items())
    group.models.push_back(read_model_entry(item));
  if (group.models.empty()) place.at("models").refuse("an array of at least one model");
  if (const auto count = place.find("count"))
    group.count = read_counts(*count, 0, kMaxObjectsOfGroup);
  if (const auto range = place.find("scale_range"))
    group.scale_range = read_interval(*range, 1e-6, 1e6);
  if (const auto rotation = place.find("rotation")) read_rotation_rule(*rotation, group);
  group.place = read_place_rule(place);
  if (const auto tries = place.find("tries")) group.tries = read_integer(*tries, 1, kMaxTriesOfPut);
  if (const auto target = place.find("target")) group.target = target->boolean();
  if (const auto look = place.find("look")) group.look = read_surface(*look);
  return group;
}

RecipeMove read_move(const JsonPlace& place) {
  if (!place.value().is_object()) place.refuse("an object with the keys op, ...");
  const JsonPlace op = place.at("op");
  RecipeMove move;
  if (op.value() == "push") {
    place.expect_object({"op", "distance"}, {"group", "count"});
    move.distance = read_interval(place.at("distance"), 0, kMaxLength);
  } else if (op.value() == "turn") {
    place.expect_object({"op", "angle_deg"}, {"group", "count"});
    move.kind = RecipeMove::Kind::Turn;
    move.angle_deg = read_interval(place.at("angle_deg"), -kMaxAngleDeg, kMaxAngleDeg);
  } else if (op.value() == "drape") {
    move = read_drape(place);
  } else {
    op.refuse("\"push\", \"turn\" or \"drape\"");
  }
  if (const auto group = place.find("group")) move.group = group->text();
  if (const auto count = place.find("count"))
    move.count = read_counts(*count, 0, kMaxObjectsOfGroup);
  return move;
}

Acceptance read_acceptance(const JsonPlace& place) {
  place.expect_object({}, {"min_objects", "stable", "min_margin", "max_refused", "attempts"});
  Acceptance out;
  if (const auto least = place.find("min_objects"))
    out.min_objects = read_integer(*least, 0, 1'000'000'000);
  if (const auto stable = place.find("stable")) out.stable = stable->boolean();
  if (const auto margin = place.find("min_margin")) out.min_margin = margin->number(0, kMaxLength);
  if (const auto most = place.find("max_refused"))
    out.max_refused = read_integer(*most, 0, 1'000'000'000);
  if (const auto attempts = place.find("attempts"))
    out.attempts = read_integer(*attempts, 1, kMaxTries);
  if (out.min_margin > 0 && !out.stable)
    place.at("min_margin")
        .fail(
            "a margin of a scene that need not be stable; accepted: with "
            "\"stable\": true");
  return out;
}

}  // namespace trivet::farm
