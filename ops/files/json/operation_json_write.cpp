// Operations as JSON; operation_json.cpp reads them.
#include <optional>

#include "ops/files/json/material_json.h"
#include "ops/files/json/operation_json.h"
#include "ops/operations/arrange_problem.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
void write_if(bool wanted, const char* key, const T& value, Json& json) {
  if (wanted) json[key] = value;
}

Json array(const Vec2& v) { return {v.x(), v.y()}; }
Json array(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

template <class Vec>
void write_via(const std::vector<Vec>& via, Json& json) {
  for (const Vec& v : via) json["via"].push_back(array(v));
}

void write_if(const char* key, const std::optional<Vec3>& value, Json& json) {
  if (value) json[key] = array(*value);
}

void write_if(const char* key, const std::optional<std::string>& value, Json& json) {
  if (value) json[key] = *value;
}

const char* to_string(TurnOperation::About about) {
  switch (about) {
    case TurnOperation::About::Normal:
      return "normal";
    case TurnOperation::About::Line:
      return "line";
    case TurnOperation::About::Point:
      return "point";
  }
  return "?";
}

void write(const PutOperation& put, Json& json) {
  if (!put.place) {
    write_pose(put.start, json);
    const PutOperation usual;
    write_if(put.tries != usual.tries, "tries", put.tries, json);
    write_if(put.within != usual.within, "within", put.within, json);
    return;
  }
  const PlaceOptions& place = *put.place;
  json["on"] = place.on;
  if (place.near)
    json["at"] = array(*place.near);
  else
    json["at"] = "anywhere";
  if (place.seed != 0) json["seed"] = place.seed;
  if (place.keep != 0) json["keep"] = place.keep;
  if (place.from) json["from"] = *place.from;
  for (const Vec2& corner : place.region) json["region"].push_back(array(corner));
  if (place.least_margin != 0) json["least_margin"] = place.least_margin;
  if (place.most_friction < kInfinity) json["most_friction"] = place.most_friction;
  const Rotation& q = put.start.rotation;
  json["rotation"] = {q.w, q.x, q.y, q.z};
}

void write(const PushOperation& push, Json& json) {
  if (push.to) {
    json["to"] = array(*push.to);
    write_via(push.via, json);
  } else {
    json["direction"] = array(push.direction);
    json["distance"] = push.distance;
  }
  const PushOperation usual;
  write_if(push.normal != usual.normal, "normal", array(push.normal), json);
  write_if(push.step_up != usual.step_up, "step_up", push.step_up, json);
  write_if(push.step_down != usual.step_down, "step_down", push.step_down, json);
  write_if(!push.slide, "slide", false, json);
  write_if(!push.settle, "settle", false, json);
}

void write(const TurnOperation& turn, Json& json) {
  json["about"] = to_string(turn.about);
  write_if("with", turn.with, json);
  const bool normal = turn.about == TurnOperation::About::Normal;
  write_if("centre", normal ? turn.centre : std::nullopt, json);
  write_if("point", normal ? std::nullopt : turn.point, json);
  write_if("axis", normal ? std::nullopt : turn.axis, json);
  json["angle_deg"] = turn.angle_deg;
  write_if(turn.settle, "settle", true, json);
}

void write(const PickUpOperation& pick_up, Json& json) {
  json["distance"] = pick_up.distance;
  write_if("with", pick_up.with, json);
}

void write(const TranslateOperation& translate, Json& json) {
  json["by"] = array(translate.by);
  write_via(translate.via, json);
  write_if(translate.free, "free", true, json);
  write_if(translate.settle, "settle", true, json);
}

void write(const RotateOperation& rotate, Json& json) {
  json["axis"] = array(rotate.axis);
  json["angle_deg"] = rotate.angle_deg;
  write_if("centre", rotate.centre, json);
  write_if(rotate.free, "free", true, json);
  write_if(rotate.settle, "settle", true, json);
}

void write(const AppendOperation& append, Json& json) {
  json["model"] = append.model;
  if (append.scale) json["scale"] = *append.scale;
  if (append.up) json["up"] = *append.up == UpAxis::Y ? "y" : "z";
  write_if(append.fixed, "fixed", true, json);
  if (append.material) json["material"] = material_json(*append.material);
  write_tessellation(append.tessellation, json);
}

void write(const DuplicateOperation& duplicate, Json& json) { json["as"] = duplicate.as; }

void write(const RenameOperation& rename, Json& json) { json["to"] = rename.to; }

void write(const DeleteOperation&, Json&) {}

void write(const StandOperation& stand, Json& json) { write_pose(stand.pose, json); }

void write(const UnplaceOperation&, Json&) {}

void write(const ArrangeOperation&, Json&) {}  // a problem of its own

void write(const LockOperation&, Json&) {}

void write(const FixOperation&, Json&) {}

void write(const MaterialOperation& o, Json& json) { json["material"] = material_json(o.material); }

void write(const GroupOperation& group, Json& json) {
  write_if(!group.group.empty(), "group", group.group, json);
}

}  // namespace

nlohmann::ordered_json operation_json(const Operation& operation) {
  if (const auto* const arrange = std::get_if<ArrangeOperation>(&operation)) {
    Json json = {{"op", op_name(operation)}};
    json.update(Json::parse(arrange->problem->json()));
    return json;
  }
  Json json = {{"op", op_name(operation)}, {"object", object_name(operation)}};
  std::visit(
      [&](const auto& o) {
        write(o, json);
        if constexpr (std::is_base_of_v<JointMoveOptions, std::decay_t<decltype(o)>>)
          write_if(!o.together.empty(), "together", o.together, json);
        if constexpr (std::is_base_of_v<MoveOptions, std::decay_t<decltype(o)>>)
          write_if(o.settle_left, "settle_left", true, json);
      },
      operation);
  return json;
}

void write_tessellation(const Tessellation& tessellation, nlohmann::ordered_json& json) {
  const Tessellation standard;
  const auto& [chord, angle] = tessellation;
  write_if(chord != standard.chord, "chord", chord, json);
  write_if(angle != standard.facet_angle_deg, "facet_angle_deg", angle, json);
}

void write_pose(const Pose& pose, nlohmann::ordered_json& json) {
  const Rotation& r = pose.rotation;
  json["position"] = array(pose.translation);
  json["rotation"] = {r.w, r.x, r.y, r.z};
}

}  // namespace trivet
