#include "ops/files/layout/layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "ops/files/arrange/marks_json.h"
#include "ops/files/arrange/operation.h"
#include "ops/files/foreign/articulation.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/looks_json.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operations.h"
#include "ops/files/json/settle_json.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/label_keys.h"
#include "ops/files/layout/named_objects.h"
#include "ops/files/layout/paths.h"

namespace trivet {
namespace {

constexpr int kLayoutVersion = 1;
constexpr double kUnitRounding = 4e-15;

constexpr std::pair<const char*, SceneRule> kSceneRules[] = {
    {"roots", SceneRule::Roots}, {"groups", SceneRule::Groups}, {"meshes", SceneRule::Meshes}};

SceneRule read_scene_rule(const JsonPlace& place) {
  for (const auto& [name, rule] : kSceneRules)
    if (place.value() == name) return rule;
  place.refuse("\"roots\", \"groups\" or \"meshes\"");
}

std::string read_name(const JsonPlace& place) {
  std::string name = place.text();
  if (name == "floor") place.refuse("any name but \"floor\", which is the floor");
  return name;
}

void write_labels(const LayoutObject& object, nlohmann::ordered_json& json) {
  if (!object.class_name.empty()) json["class"] = object.class_name;
  if (!object.attributes.empty())
    json["attributes"] = nlohmann::ordered_json::parse(object.attributes);
}

void read_matter(const JsonPlace& place, LayoutObject& object) {
  if (const auto material = place.find("material")) object.material = read_material(*material);
  if (const auto mass = place.find("mass")) object.mass = read_mass(*mass);
}

// One that the scene has, where the scene has it.
LayoutObject read_scene_object(const JsonPlace& place) {
  place.expect_object({"name"}, {"fixed", "material", "mass", "class", "attributes"});
  LayoutObject object;
  object.name = read_name(place.at("name"));
  read_labels(place, object);
  if (const auto fixed = place.find("fixed")) object.fixed = fixed->boolean();
  read_matter(place, object);
  return object;
}

// Its marks for the section "arrange" go there.
LayoutObject read_object(const JsonPlace& place) {
  place.expect_object(
      {"name", "model"},
      {"collision", "scale", "up", "fixed", "material", "mass", "chord", "facet_angle_deg",
       "position", "rotation", "joint", "class", "attributes", "front", "zones", "surfaces"});
  LayoutObject object;
  read_labels(place, object);
  object.name = read_name(place.at("name"));
  object.model = place.at("model").text();
  if (const auto collision = place.find("collision")) object.collision = collision->text();
  if (const auto scale = place.find("scale")) object.scale = scale->number(kMinScale, kMaxScale);
  if (const auto up = place.find("up")) object.up = read_up(*up);
  if (const auto fixed = place.find("fixed")) object.fixed = fixed->boolean();
  read_matter(place, object);
  object.tessellation = read_tessellation(place, object.model);
  if (place.find("position")) object.pose = read_pose(place);
  if (const auto joint = place.find("joint")) {
    object.joint = read_joint(*joint);
    if (!object.pose) joint->fail("a joint without a position; accepted: both");
  }
  if (const auto rotation = place.find("rotation"); rotation && !object.pose)
    rotation->fail(
        "a rotation without a position; accepted: both, or neither for an object that "
        "is out of the scene until it is put");
  return object;
}

// Objects hang in others before them that stand from the start: so there is no circle.
void check_joint(const JsonPlace& item, const Layout& layout) {
  if (!item.find("joint")) return;
  const LayoutObject& link = layout.objects.back();
  const auto is_parent = [&](const LayoutObject& o) { return o.name == link.joint->in && o.pose; };
  if (std::none_of(layout.objects.begin(), layout.objects.end() - 1, is_parent))
    item.at("joint").at("in").refuse(
        Sentence("the name of one of /objects before it, with a position"));
}

// A file of bodies in joints becomes an object a body.
void read_articulation(const JsonPlace& place, const std::string& folder, Layout& layout) {
  place.expect_object({"name", "articulation", "position"}, {"rotation", "fixed"});
  PlacedArticulation placed;
  placed.name = read_name(place.at("name"));
  placed.file = place.at("articulation").text();
  placed.pose = read_pose(place);
  if (const auto fixed = place.find("fixed")) placed.fixed = fixed->boolean();
  try {
    add_articulation(placed, folder, layout);
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::BadInput) throw;
    place.at("articulation").fail(error.sentence());
  }
}

// @param folder  of the layout.
void read_objects(const JsonPlace& place, const std::string& folder, Layout& layout) {
  const bool of_scene = !layout.scene.empty();
  std::map<std::string, size_t> index_of;  // of the entry that has a name
  const std::vector<JsonPlace> items = place.items();
  for (size_t i = 0; i < items.size(); ++i) {
    size_t num = layout.objects.size();
    if (items[i].value().is_object() && items[i].find("articulation") && !of_scene)
      read_articulation(items[i], folder, layout);
    else
      layout.objects.push_back(of_scene ? read_scene_object(items[i]) : read_object(items[i]));
    for (; num < layout.objects.size(); ++num) {
      const auto [it, is_new] = index_of.emplace(layout.objects[num].name, i);
      if (!is_new)
        items[i].at("name").fail(
            say("%1 is already the name of /objects/%2; accepted: a name of its own",
                items[i].at("name").value().dump(), it->second));
    }
    if (!layout.objects.empty() && layout.objects.back().joint) check_joint(items[i], layout);
  }
}

// @param objects  at this point; brought up to date.
Operation read_known(const JsonPlace& place, NamedObjects& objects) {
  Operation operation = read_operation(place);
  if (std::holds_alternative<ArrangeOperation>(operation)) {
    check_names(place, objects.names());
    return operation;
  }
  const auto refuse = [&](const JsonPlace& where, const Sentence& accepted) {
    where.refuse(say("%1%2", accepted, did_you_mean(where.text(), objects.names())));
  };
  const auto* const drape = std::get_if<DrapeOperation>(&operation);
  if (!std::holds_alternative<AppendOperation>(operation) && !(drape && !drape->again) &&
      !std::holds_alternative<RepairOperation>(operation) &&
      !objects.contains(object_name(operation)))
    refuse(place.at("object"), "the name of one of /objects");
  if (const auto given = given_name(operation); given && objects.contains(*given->name))
    place.at(given->key).refuse("a name that no object has");
  if (const auto* put = std::get_if<PutOperation>(&operation))
    if (put->place && put->place->on != "floor" && !objects.contains(put->place->on))
      refuse(place.at("on"), "\"floor\" or the name of one of /objects");
  if (drape && drape->of && !objects.contains(*drape->of))
    refuse(place.at("of"), "the name of one of /objects");
  for (const char* const key : {"together", "only"})
    if (const auto names = place.find(key))
      for (const JsonPlace& other : names->items())
        if (!objects.contains(other.text())) refuse(other, "the name of one of /objects");
  objects.follow(operation);
  return operation;
}

}  // namespace

void read_labels(const JsonPlace& place, LayoutObject& object) {
  if (const auto name = place.find("class")) object.class_name = name->text();
  const auto attributes = place.find("attributes");
  if (!attributes) return;
  if (!attributes->value().is_object())
    attributes->refuse("an object of names and texts, numbers, true or false");
  for (const auto& [key, value] : attributes->value().items())
    if (value.is_structured() || value.is_null())
      attributes->at(key.c_str()).refuse("a text, a number, true or false");
  object.attributes = attributes->value().dump();
}

std::optional<Rotation> unit_rotation(const std::array<double, 4>& q) {
  const auto is_large = [](double c) { return std::abs(c) >= kMinQuaternionComponent; };
  if (std::none_of(q.begin(), q.end(), is_large)) return std::nullopt;
  const Rotation rotation{q[0], q[1], q[2], q[3]};
  const double squared_length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return std::abs(squared_length - 1) <= kUnitRounding ? rotation : rotation.normalized();
}

Layout parse_layout(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text, file);
  const JsonPlace root(document, file);
  root.expect_object({"trivet", "objects"},
                     {"floor", "material", "floor_material", "pairs", "settle", "scene",
                      "scene_objects", "operations", "looks", "arrange"});
  const JsonPlace version = root.at("trivet");
  if (!version.value().is_number() || version.value() != kLayoutVersion)
    version.refuse(say("%1, the version of the layout format", kLayoutVersion));

  Layout layout;
  if (const auto scene = root.find("scene")) layout.scene = scene->text();
  if (const auto rule = root.find("scene_objects")) {
    if (layout.scene.empty()) rule->fail("there is no \"scene\" for it");
    layout.scene_rule = read_scene_rule(*rule);
  }
  layout.floor = layout.scene.empty();  // a scene has its own
  if (const auto floor = root.find("floor")) layout.floor = floor->boolean();
  if (const auto material = root.find("material")) layout.material = read_material(*material);
  if (const auto material = root.find("floor_material"))
    layout.floor_material = read_material(*material);
  if (const auto pairs = root.find("pairs")) layout.pairs = read_pair_rules(*pairs);
  if (const auto settle = root.find("settle")) {
    settle->expect_object({},
                          {"perfect_friction", "whole_at_rest", "literal_paper_rules", "robust"});
    layout.settle = read_settle_rules(*settle);
  }
  read_objects(root.at("objects"), folder_of(file), layout);
  NamedObjects objects(layout.objects);
  if (const auto operations = root.find("operations"))
    for (const JsonPlace& item : operations->items())
      layout.operations.push_back(read_known(item, objects));
  if (const auto looks = root.find("looks")) layout.looks = read_looks(*looks);
  if (root.find("arrange"))
    layout.arrange = section_with_marks(root).dump();
  else
    for (const JsonPlace& object : root.at("objects").items()) refuse_marks(object);
  return layout;
}

Layout read_layout(const std::string& path, std::uintmax_t max_bytes) {
  return parse_layout(read_input_text(path, max_bytes, TextKind::Json), path);
}

std::string write_layout(const Layout& layout) {
  using Json = nlohmann::ordered_json;
  Json json = {{"trivet", kLayoutVersion}, {"floor", layout.floor}};
  write_material("material", layout.material, json);
  if (layout.floor_material) json["floor_material"] = material_json(*layout.floor_material);
  if (!layout.pairs.empty()) json["pairs"] = pair_rules_json(layout.pairs);
  if (const Json settle = settle_rules_json(layout.settle); !settle.empty())
    json["settle"] = settle;
  if (!layout.scene.empty()) {
    json["scene"] = layout.scene;
    for (const auto& [name, rule] : kSceneRules)
      if (rule == layout.scene_rule) json["scene_objects"] = name;
  }
  json["objects"] = Json::array();
  for (const LayoutObject& o : layout.objects) {
    Json entry = {{"name", o.name}};
    if (layout.scene.empty()) entry["model"] = o.model;
    if (!o.collision.empty()) entry["collision"] = o.collision;
    if (layout.scene.empty() && o.scale) entry["scale"] = *o.scale;
    if (o.up) entry["up"] = *o.up == UpAxis::Y ? "y" : "z";
    if (o.fixed) entry["fixed"] = true;
    if (o.material) entry["material"] = material_json(*o.material);
    if (o.mass) entry["mass"] = mass_json(*o.mass);
    write_tessellation(o.tessellation, entry);
    if (o.pose) write_pose(*o.pose, entry);
    if (o.joint) entry["joint"] = joint_json(*o.joint);
    write_labels(o, entry);
    json["objects"].push_back(std::move(entry));
  }
  json["operations"] = Json::array();
  for (const Operation& o : layout.operations) json["operations"].push_back(operation_json(o));
  if (!layout.looks.empty()) json["looks"] = looks_json(layout.looks);
  if (!layout.arrange.empty()) json["arrange"] = Json::parse(layout.arrange);
  return readable_json(json);
}

}  // namespace trivet
