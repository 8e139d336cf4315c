#include "ops/files/json/operation_json.h"

#include <iterator>
#include <utility>

#include "core/base/nearest_name.h"
#include "ops/files/arrange/operation.h"
#include "ops/files/json/material_json.h"
#include "ops/files/layout/layout.h"
#include "ops/operations/validate.h"

namespace trivet {
namespace {

template <class Vec>
void read_via(const JsonPlace& place, std::vector<Vec>& out) {
  if (const auto via = place.find("via"))
    for (const JsonPlace& item : via->items()) out.push_back(read_vector(item, Vec()));
}

std::string read_new_name(const JsonPlace& place) {
  std::string name = place.text();
  if (name == "floor") place.refuse("any name but \"floor\", which is the floor");
  return name;
}

void read_common(const JsonPlace& place, MoveOptions& move) {
  move.object = place.at("object").text();
  read_to(place, "settle_left", move.settle_left);
}

void read_common(const JsonPlace& place, JointMoveOptions& move) {
  read_common(place, static_cast<MoveOptions&>(move));
  if (const auto together = place.find("together"))
    for (const JsonPlace& other : together->items()) move.together.push_back(other.text());
}

PlaceOptions read_place(const JsonPlace& place) {
  place.expect_object({"op", "object", "on"},
                      {"at", "seed", "keep", "from", "region", "least_margin", "most_friction",
                       "rotation", "settle_left"});
  PlaceOptions out;
  out.on = place.at("on").text();
  if (const auto at = place.find("at")) {
    if (at->value().is_array())
      out.near = read_vec2(*at);
    else if (at->value() != "anywhere")
      at->refuse("\"anywhere\" or a point [x, y]");
  }
  if (const auto seed = place.find("seed")) {
    if (!seed->value().is_number_unsigned()) seed->refuse("a whole number from 0 to 2^53");
    out.seed = seed->value().get<std::uint64_t>();
  }
  read_to(place, "keep", out.keep);
  read_to(place, "least_margin", out.least_margin);
  read_to(place, "most_friction", out.most_friction);
  if (const auto from = place.find("from")) out.from = from->number();
  if (const auto region = place.find("region")) out.region = read_region(*region);
  return out;
}

void read_tries(const JsonPlace& place, PutOperation& put) {
  if (const auto tries = place.find("tries")) {
    const double number = tries->value().is_number_integer() ? tries->number() : 0;
    if (number < 1 || number > kMaxTriesOfPut)
      tries->refuse(say("a whole number from 1 to %1", kMaxTriesOfPut));
    put.tries = static_cast<int>(number);
  }
  read_to(place, "within", put.within);
}

PutOperation read_put(const JsonPlace& place) {
  if (place.find("on") || place.find("at")) {
    PutOperation put;
    put.place = read_place(place);
    read_common(place, put);
    if (const auto rotation = place.find("rotation")) put.start.rotation = read_rotation(*rotation);
    return put;
  }
  if (!place.find("position")) {
    place.expect_object({"op", "object"}, {"rotation", "tries", "within", "settle_left"});
    place.fail(
        "a place is missing; accepted: \"position\", from where it falls, or \"on\", an object or "
        "\"floor\", on which a place is found");
  }
  place.expect_object({"op", "object", "position"}, {"rotation", "tries", "within", "settle_left"});
  PutOperation put;
  read_common(place, put);
  put.start = read_pose(place);
  read_tries(place, put);
  return put;
}

PushOperation read_push(const JsonPlace& place) {
  if (!place.find("to") && !place.find("direction") && !place.find("distance")) {
    place.expect_object({"op", "object"}, {"normal", "step_up", "step_down", "slide", "settle",
                                           "together", "settle_left"});
    place.fail("a target is missing; accepted: \"to\", or \"direction\" and \"distance\"");
  }
  PushOperation push;
  if (place.find("to")) {
    place.expect_object({"op", "object", "to"}, {"via", "normal", "step_up", "step_down", "slide",
                                                 "settle", "together", "settle_left"});
    push.to = read_vec2(place.at("to"));
    read_via(place, push.via);
  } else {
    place.expect_object(
        {"op", "object", "direction", "distance"},
        {"normal", "step_up", "step_down", "slide", "settle", "together", "settle_left"});
    push.direction = read_vec2(place.at("direction"));
    push.distance = place.at("distance").number();
  }
  read_common(place, push);
  if (const auto normal = place.find("normal")) push.normal = read_vec3(*normal);
  read_to(place, "step_up", push.step_up);
  read_to(place, "step_down", push.step_down);
  read_to(place, "slide", push.slide);
  read_to(place, "settle", push.settle);
  return push;
}

TurnOperation::About read_about(const JsonPlace& place) {
  if (place.value() == "normal") return TurnOperation::About::Normal;
  if (place.value() == "line") return TurnOperation::About::Line;
  if (place.value() == "point") return TurnOperation::About::Point;
  place.refuse("\"normal\", \"line\" or \"point\"");
}

TurnOperation read_turn(const JsonPlace& place) {
  TurnOperation turn;
  if (place.find("about")) turn.about = read_about(place.at("about"));
  switch (turn.about) {
    case TurnOperation::About::Normal:
      place.expect_object({"op", "object", "angle_deg"},
                          {"about", "with", "centre", "settle", "together", "settle_left"});
      read_to(place, "centre", turn.centre);
      break;
    case TurnOperation::About::Line:
    case TurnOperation::About::Point:
      place.expect_object({"op", "object", "about", "angle_deg"},
                          {"with", "point", "axis", "settle", "together", "settle_left"});
      read_to(place, "point", turn.point);
      read_to(place, "axis", turn.axis);
      break;
  }
  read_common(place, turn);
  read_to(place, "with", turn.with);
  turn.angle_deg = place.at("angle_deg").number();
  read_to(place, "settle", turn.settle);
  return turn;
}

PickUpOperation read_pick_up(const JsonPlace& place) {
  place.expect_object({"op", "object", "distance"}, {"with", "together", "settle_left"});
  PickUpOperation pick_up;
  read_common(place, pick_up);
  pick_up.distance = place.at("distance").number();
  read_to(place, "with", pick_up.with);
  return pick_up;
}

TranslateOperation read_translate(const JsonPlace& place) {
  place.expect_object({"op", "object", "by"}, {"via", "free", "settle", "together", "settle_left"});
  TranslateOperation translate;
  read_common(place, translate);
  translate.by = read_vec3(place.at("by"));
  read_via(place, translate.via);
  read_to(place, "free", translate.free);
  read_to(place, "settle", translate.settle);
  return translate;
}

RotateOperation read_rotate(const JsonPlace& place) {
  place.expect_object({"op", "object", "axis", "angle_deg"},
                      {"centre", "free", "settle", "together", "settle_left"});
  RotateOperation rotate;
  read_common(place, rotate);
  rotate.axis = read_vec3(place.at("axis"));
  rotate.angle_deg = place.at("angle_deg").number();
  read_to(place, "centre", rotate.centre);
  read_to(place, "free", rotate.free);
  read_to(place, "settle", rotate.settle);
  return rotate;
}

AppendOperation read_append(const JsonPlace& place) {
  place.expect_object({"op", "object", "model"},
                      {"scale", "up", "fixed", "material", "chord", "facet_angle_deg"});
  AppendOperation append;
  append.object = read_new_name(place.at("object"));
  append.model = place.at("model").text();
  read_to(place, "scale", append.scale);
  if (const auto up = place.find("up")) append.up = read_up(*up);
  read_to(place, "fixed", append.fixed);
  if (const auto material = place.find("material")) append.material = read_material(*material);
  append.tessellation = read_tessellation(place, append.model);
  return append;
}

DuplicateOperation read_duplicate(const JsonPlace& place) {
  place.expect_object({"op", "object", "as"}, {});
  return {place.at("object").text(), read_new_name(place.at("as"))};
}

RenameOperation read_rename(const JsonPlace& place) {
  place.expect_object({"op", "object", "to"}, {});
  return {place.at("object").text(), read_new_name(place.at("to"))};
}

// Delete and unplace.
template <class Removal>
Removal read_removal(const JsonPlace& place) {
  place.expect_object({"op", "object"}, {"settle_left"});
  Removal operation;
  read_common(place, operation);
  return operation;
}

StandOperation read_stand(const JsonPlace& place) {
  place.expect_object({"op", "object", "position"}, {"rotation", "settle_left"});
  StandOperation operation;
  read_common(place, operation);
  operation.pose = read_pose(place);
  return operation;
}

template <bool kLocked>
LockOperation read_lock(const JsonPlace& place) {
  place.expect_object({"op", "object"}, {});
  return {place.at("object").text(), kLocked};
}

template <bool kFixed>
FixOperation read_fix(const JsonPlace& place) {
  place.expect_object({"op", "object"}, {});
  return {place.at("object").text(), kFixed};
}

MaterialOperation read_material_operation(const JsonPlace& place) {
  place.expect_object({"op", "object", "material"}, {});
  return {place.at("object").text(), read_material(place.at("material"))};
}

GroupOperation read_group(const JsonPlace& place) {
  place.expect_object({"op", "object", "group"}, {});
  return {place.at("object").text(), place.at("group").text()};
}

GroupOperation read_ungroup(const JsonPlace& place) {
  place.expect_object({"op", "object"}, {});
  return {place.at("object").text(), ""};
}

template <auto kRead>
Operation read_by(const JsonPlace& place) {
  return kRead(place);
}

constexpr std::pair<const char*, Operation (*)(const JsonPlace&)> kReaders[] = {
    {"put", read_by<read_put>},
    {"push", read_by<read_push>},
    {"turn", read_by<read_turn>},
    {"pick_up", read_by<read_pick_up>},
    {"translate", read_by<read_translate>},
    {"rotate", read_by<read_rotate>},
    {"append", read_by<read_append>},
    {"duplicate", read_by<read_duplicate>},
    {"delete", read_by<read_removal<DeleteOperation>>},
    {"lock", read_by<read_lock<true>>},
    {"unlock", read_by<read_lock<false>>},
    {"fix", read_by<read_fix<true>>},
    {"unfix", read_by<read_fix<false>>},
    {"material", read_by<read_material_operation>},
    {"group", read_by<read_group>},
    {"ungroup", read_by<read_ungroup>},
    {"stand", read_by<read_stand>},
    {"unplace", read_by<read_removal<UnplaceOperation>>},
    {"arrange", read_by<read_arrange>},
    {"rename", read_by<read_rename>},
};

[[noreturn]] void refuse_unknown_op(const JsonPlace& op) {
  std::vector<std::string> names;
  std::string list;
  for (const auto& [name, read] : kReaders) {
    if (!names.empty()) list += names.size() + 1 == std::size(kReaders) ? " or " : ", ";
    list.append("\"").append(name).append("\"");
    names.emplace_back(name);
  }
  const std::string given = op.value().is_string() ? op.value().get<std::string>() : "";
  op.refuse(say("%1%2", list, did_you_mean(given, names)));
}

Operation read_values(const JsonPlace& place) {
  if (!place.value().is_object()) place.refuse("an object with the keys op, object, ...");
  const JsonPlace op = place.at("op");
  for (const auto& [name, read] : kReaders)
    if (op.value() == name) return read(place);
  refuse_unknown_op(op);
}

}  // namespace

Operation read_operation(const JsonPlace& place) {
  Operation operation = read_values(place);
  if (const auto found = find_invalid_argument(operation))
    place.at(found->key.c_str()).refuse(found->accepted);
  return operation;
}

}  // namespace trivet
