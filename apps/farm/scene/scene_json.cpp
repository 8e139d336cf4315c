#include "apps/farm/scene/scene_json.h"

#include <cmath>
#include <map>

#include "apps/farm/store/damage.h"
#include "core/base/bad_input.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operations.h"
#include "ops/files/labels/labelled_scene.h"
#include "ops/files/layout/named_objects.h"
#include "ops/files/report/json_parts.h"
#include "ops/stability/stability.h"
#include "ops/stability/weight.h"

namespace trivet::farm {
namespace {

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void add_pose(const Object& object, Json& json) {
  json["position"] = to_json(object.pose.translation);
  const Rotation& r = object.pose.rotation;
  json["rotation"] = {r.w, r.x, r.y, r.z};
}

std::string class_of(const Object& object, const LayoutObject& wanted) {
  if (!wanted.class_name.empty()) return wanted.class_name;
  const std::string stem = class_of_model(object.model->path);
  return stem.empty() ? object.name : stem;  // as in labelled images
}

Json object_of_scene(const Object& object, const LayoutObject& wanted, const std::string& reason) {
  Json json = {{"name", object.name}, {"model", object.model->path}, {"scale", object.scale}};
  if (!wanted.collision.empty()) json["collision"] = wanted.collision;
  json["up"] = object.up == UpAxis::Y ? "y" : "z";
  write_tessellation(wanted.tessellation, json);
  json["material"] = material_json(object.material);
  if (object.given_mass) json["mass"] = mass_json(*object.given_mass);
  json["kilograms"] = weight_of(object) / kGravity;
  json["class"] = class_of(object, wanted);
  if (object.flexible) json["draped"] = true;
  if (!wanted.attributes.empty()) json["attributes"] = Json::parse(wanted.attributes);
  if (object.fixed) json["fixed"] = true;
  if (object.placed) {
    add_pose(object, json);
  } else {
    json["position"] = json["rotation"] = nullptr;
  }
  json["state"] = to_string(object.state);
  if (!reason.empty()) json["reason"] = reason;
  return json;
}

// Supports of objects that are in the scene and may move: "floor" or names.
std::map<std::string, Json> supports_by_name(const Scene& scene) {
  std::map<std::string, Json> out;
  for (const LoadSupport::Entry& entry : load_support(scene).entries)
    if (const Object& object = scene.at(entry.object); !object.fixed)
      out[object.name] = supports_json(scene, entry);
  return out;
}

double least_friction(const Scene& scene) {
  double out = 0;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.placed && !object.fixed) out = std::max(out, object.least_friction);
  }
  return out;
}

void add_totals(const MadeScene& made, Json& json) {
  const LayoutRun& run = made.run;
  size_t refused = 0, triangles = 0;
  double kilograms = 0;
  for (const OperationRecord& record : run.operations) refused += record.result.ok() ? 0 : 1;
  for (const ObjectId id : run.scene.ids()) {
    const Object& object = run.scene.at(id);
    if (!object.placed) continue;
    triangles += object.shape->mesh.triangles.size();
    if (!object.fixed) kilograms += weight_of(object) / kGravity;
  }
  json["operations"] = run.operations.size();
  json["refused"] = refused;
  json["triangles"] = triangles;
  json["kilograms"] = kilograms;
  json["stability"] = to_string(run.stability.status);
  json["margin"] = finite(run.stability.margin);
  json["smallest_gap"] = finite(run.check.smallest_gap);
  json["least_friction"] = finite(least_friction(run.scene));
}

}  // namespace

Json scene_json(std::uint64_t k, const MadeScene& made) {
  Json json = {{"k", k}, {"status", made.accepted ? "ok" : "refused"}};
  if (!made.accepted) json["reason"] = made.reason;
  json["attempt"] = made.attempt;
  add_totals(made, json);
  const NamedObjects wanted = objects_after(made.layout);
  const LayoutObject none;
  const std::map<std::string, Json> supports = supports_by_name(made.run.scene);
  Json objects = Json::array();
  for (const ObjectId id : made.run.scene.ids()) {
    const Object& object = made.run.scene.at(id);
    const auto left_out = made.left_out.find(object.name);
    const LayoutObject* const own = wanted.find(object.name);
    objects.push_back(object_of_scene(object, own ? *own : none,
                                      left_out == made.left_out.end() ? "" : left_out->second));
    if (const auto found = supports.find(object.name); found != supports.end())
      objects.back()["supports"] = found->second;
  }
  json["objects"] = std::move(objects);
  return json;
}

Json failed_scene_json(std::uint64_t k, const std::string& reason) {
  return {{"k", k}, {"status", "failed"}, {"reason", reason}, {"objects", Json::array()}};
}

Json manifest_row(const Json& scene) {
  Json row = scene;
  size_t placed = 0;
  std::map<std::string, int> classes;
  for (const Json& object : scene.at("objects")) {
    if (object.at("position").is_null()) continue;
    ++placed;
    if (object.contains("class")) ++classes[object.at("class").get<std::string>()];
  }
  row["objects"] = placed;
  if (scene.contains("kilograms")) row["classes"] = classes;  // scenes of before have neither
  return row;
}

std::string json_line(const Json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

namespace {

Json placed_objects(const Json& scene) {
  Json out = Json::array();
  for (Json object : scene.at("objects")) {
    if (object.at("position").is_null()) continue;
    for (const char* const told : {"state", "kilograms", "supports"}) object.erase(told);
    out.push_back(std::move(object));
  }
  return out;
}

// Poses alone do not tell their shapes.
void refuse_draped(const Json& scene, const std::string& where) {
  for (const Json& object : scene.at("objects"))
    if (object.value("draped", false))
      bad_file(where,
               say("has \"%1\", which was draped, and keeps poses alone; accepted: its .glb, "
                   "which --with scene writes",
                   object.at("name").get<std::string>()));
}

}  // namespace

Layout layout_of_poses(const Recipe& recipe, const Json& scene, const std::string& where) {
  const auto read = [&] {
    refuse_draped(scene, where);
    return placed_objects(scene);
  };
  const Json json = {
      {"trivet", 1}, {"floor", recipe.base.floor}, {"objects", read_undamaged(where, read)}};
  Layout layout = parse_layout(json.dump(), where);
  layout.settle = recipe.base.settle;
  layout.material = recipe.base.material;
  layout.floor_material = recipe.base.floor_material;
  return layout;
}

}  // namespace trivet::farm
