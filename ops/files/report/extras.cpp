#include "ops/files/report/extras.h"

#include <map>
#include <set>

#include "core/base/extension.h"
#include "core/io/json.h"
#include "core/io/mesh_model.h"
#include "core/model/exported_floats.h"
#include "core/scene/collision_mesh.h"
#include "ops/files/foreign/articulation.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/json/operations.h"
#include "ops/files/json/text.h"
#include "ops/files/json/values.h"
#include "ops/files/report/flexible_json.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/report.h"
#include "ops/files/report/stored_mesh.h"

namespace trivet {
namespace {

constexpr int kExtrasVersion = 1;
constexpr double kMaxCount = 1e15;
constexpr double kMostKinds = 1e9;

// True for files that may have more digits than float32, whoever gave the model.
bool is_text_format(const std::string& path) {
  const std::string extension = lower_extension(path);
  return is_link_model(path) || extension == ".obj" || extension == ".stl" || extension == ".ply" ||
         extension == ".3mf";
}

// @param shown  by a node of the scene.
OrderedJson model_json(const Model& model, bool shown, const SceneFileOptions& options) {
  const StoredGeometry stored = stored_geometry(model);
  OrderedJson json = OrderedJson::object();
  if (!model.path.empty()) json["path"] = joined_path(options.model_folder, model.path);
  json.update({{"triangles", stored.num_triangles},
               {"fingerprint", stored.fingerprint},
               {"stored_fingerprint", stored.stored_fingerprint},
               {"centre", to_json(stored.centre)},
               {"face_order", stored.face_order}});
  if (stored.own_nodes) json["own_nodes"] = true;
  // Scenes come back to the bit without their models' files, but for those with many doubles that
  // these have anyway: curved surfaces, nodes with transforms.
  const bool lossy = stored.stored_fingerprint != stored.fingerprint;
  if (model.path.empty() ? !shown || lossy : shown && lossy && is_text_format(model.path))
    json["mesh"] = stored_mesh_json(model, !shown);
  write_tessellation(model.tessellation, json);
  return json;
}

/// A model, and where another mesh is judged what all copies of its shape share.
using DrawnAndJudged = std::pair<const Model*, const ShapeIndex*>;
DrawnAndJudged drawn_and_judged(const Object& object) {
  return {object.model.get(), has_collision_mesh(object) ? object.shape->index.get() : nullptr};
}

OrderedJson stored_object_json(const Scene& scene, const Object& object, size_t model) {
  OrderedJson json = {
      {"name", object.name},   {"model", model},        {"up", object.up == UpAxis::Y ? "y" : "z"},
      {"scale", object.scale}, {"fixed", object.fixed}, {"state", to_string(object.state)}};
  if (object.locked) json["locked"] = true;
  if (!object.group.empty()) json["group"] = object.group;
  write_material("material", object.material, json);
  if (object.given_mass) json["mass"] = mass_json(*object.given_mass);
  if (object.pair_kind != 0) json["pair_kind"] = object.pair_kind;
  if (object.joint) json["joint"] = stored_joint_json(named_joint(scene, *object.joint));
  if (object.flexible) json["flexible"] = stored_flexible_json(*object.flexible);
  if (!object.placed) return json;
  const Rotation& r = object.pose.rotation;
  json["position"] = to_json(object.pose.translation);
  json["rotation"] = {r.w, r.x, r.y, r.z};
  return json;
}

OrderedJson load_support_json(const Scene& scene) {
  OrderedJson json = OrderedJson::array();
  for (const LoadSupport::Entry& entry : load_support(scene).entries) {
    OrderedJson loads = OrderedJson::array();
    for (const ObjectId id : entry.loads) loads.push_back(scene.at(id).name);
    json.push_back({{"object", scene.at(entry.object).name},
                    {"supports", supports_json(scene, entry)},
                    {"loads", std::move(loads)}});
  }
  return json;
}

OrderedJson layout_json(Layout layout, const SceneFileOptions& options) {
  for (LayoutObject& object : layout.objects)
    for (std::string* const path : {&object.model, &object.collision})
      if (!path->empty()) *path = joined_path(options.model_folder, *path);
  layout.settle = rules_of(with_rules({}, layout.settle));  // none stated: those of today
  return OrderedJson::parse(write_layout(layout));
}

ExtrasModel read_model_entry(const JsonPlace& place) {
  place.expect_object(
      {"triangles", "fingerprint", "stored_fingerprint", "centre"},
      {"path", "face_order", "own_nodes", "mesh", "collision", "chord", "facet_angle_deg"});
  ExtrasModel model;
  if (const auto path = place.find("path")) model.path = path->text();
  model.tessellation = read_tessellation(place, model.path);
  StoredGeometry& stored = model.geometry;
  stored.num_triangles = static_cast<std::int64_t>(place.at("triangles").number(0, kMaxCount));
  stored.fingerprint = place.at("fingerprint").text();
  stored.stored_fingerprint = place.at("stored_fingerprint").text();
  const std::vector<double> centre = place.at("centre").numbers(3, -1e300, 1e300);
  stored.centre = {centre[0], centre[1], centre[2]};
  if (const auto own = place.find("own_nodes")) stored.own_nodes = own->boolean();
  if (const auto mesh = place.find("mesh")) {
    model.mesh = std::make_shared<const Model>(read_stored_mesh(*mesh));
    if (geometry_fingerprint(model.mesh->mesh) != stored.fingerprint)
      mesh->fail("is not the mesh that Trivet wrote");
  }
  if (const auto mesh = place.find("collision"))
    model.collision = std::make_shared<const Model>(read_stored_mesh(*mesh));
  if (const auto order = place.find("face_order"))
    for (const JsonPlace& run : order->items()) {
      const std::vector<double> entry = run.numbers(2, 0, kMaxCount);
      stored.face_order.push_back(
          {static_cast<std::int64_t>(entry[0]), static_cast<std::int64_t>(entry[1])});
    }
  return model;
}

ObjectState read_object_state(const JsonPlace& place) {
  for (const ObjectState state :
       {ObjectState::Unplaced, ObjectState::Fixed, ObjectState::Stable, ObjectState::Wedged,
        ObjectState::Held, ObjectState::Unsupported, ObjectState::Invalid})
    if (place.value() == to_string(state)) return state;
  place.refuse(
      "\"unplaced\", \"fixed\", \"stable\", \"wedged\", \"held\", \"unsupported\" or \"invalid\"");
}

PairKind read_kind(const JsonPlace& place) {
  return static_cast<PairKind>(place.number(0, kMostKinds));
}

std::shared_ptr<const PairRules> read_kind_rules(const JsonPlace& place) {
  auto out = std::make_shared<PairRules>();
  for (const JsonPlace& item : place.items()) {
    item.expect_object({"kinds"}, {"may_pass", "friction"});
    const std::vector<double> kinds = item.at("kinds").numbers(2, 0, kMostKinds);
    PairRule rule;
    if (const auto may = item.find("may_pass")) rule.may_pass = may->boolean();
    if (const auto mu = item.find("friction"))
      rule.friction = mu->number(kMinFriction, kMaxFriction);
    out->set(static_cast<PairKind>(kinds[0]), static_cast<PairKind>(kinds[1]), rule);
  }
  return out;
}

OrderedJson kind_rules_json(const PairRules& rules) {
  OrderedJson json = OrderedJson::array();
  for (const auto& [kinds, rule] : rules.all()) {
    json.push_back({{"kinds", {kinds.first, kinds.second}}});
    if (rule.may_pass) json.back()["may_pass"] = true;
    if (rule.friction) json.back()["friction"] = *rule.friction;
  }
  return json;
}

// Poses come from Trivet and are taken as they are: no bit may change.
ExtrasObject read_object_entry(const JsonPlace& place, size_t num_models) {
  place.expect_object({"name", "model", "up", "scale", "fixed", "state"},
                      {"position", "rotation", "locked", "group", "material", "mass", "pair_kind",
                       "joint", "flexible"});
  ExtrasObject object;
  object.name = place.at("name").text();
  const double last_model = static_cast<double>(num_models) - 1;
  object.model = static_cast<size_t>(place.at("model").number(0, last_model));
  object.up = place.at("up").value() == "y" ? UpAxis::Y : UpAxis::Z;
  object.scale = place.at("scale").number(kMinScale, kMaxScale);
  object.fixed = place.at("fixed").boolean();
  object.state = read_object_state(place.at("state"));
  if (const auto locked = place.find("locked")) object.locked = locked->boolean();
  if (const auto group = place.find("group")) object.group = group->text();
  if (const auto material = place.find("material")) object.material = read_material(*material);
  if (const auto mass = place.find("mass")) object.mass = read_mass(*mass);
  if (const auto kind = place.find("pair_kind")) object.pair_kind = read_kind(*kind);
  if (const auto joint = place.find("joint")) object.joint = read_stored_joint(*joint);
  if (const auto flexible = place.find("flexible"))
    object.flexible = std::make_shared<const Flexible>(read_stored_flexible(*flexible));
  if (!place.find("position")) return object;
  const std::vector<double> r = place.at("rotation").numbers(4, -2, 2);
  object.pose = Pose{{r[0], r[1], r[2], r[3]}, read_position(place.at("position"))};
  return object;
}

}  // namespace

std::string scene_extras(const Scene& scene, const Layout& layout,
                         const SceneFileOptions& options) {
  OrderedJson models = OrderedJson::array(), objects = OrderedJson::array();
  std::map<DrawnAndJudged, size_t> index_of;
  std::set<DrawnAndJudged> shown;
  for (const ObjectId id : scene.ids())
    if (scene.at(id).placed) shown.insert(drawn_and_judged(scene.at(id)));
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    const DrawnAndJudged of = drawn_and_judged(object);
    const auto [it, is_new] = index_of.emplace(of, models.size());
    if (is_new) {
      models.push_back(model_json(*object.model, shown.contains(of), options));
      if (of.second)
        models.back()["collision"] = stored_mesh_json(model_of_mesh(object.shape->mesh), false);
    }
    objects.push_back(stored_object_json(scene, object, it->second));
  }
  OrderedJson json = {{"trivet", kExtrasVersion},
                      {"version", options.version},
                      {"floor", scene.floor},
                      {"clearance", options.clearance}};
  write_material("floor_material", scene.floor_material, json);
  if (scene.pair_rules) {
    json["pair_rules"] = kind_rules_json(*scene.pair_rules);
    json["floor_kind"] = scene.floor_kind;
  }
  json["models"] = std::move(models);
  json["objects"] = std::move(objects);
  json["load_support"] = load_support_json(scene);
  const Vec3 origin = export_origin(scene.box());
  if (!origin.isZero(0)) json["origin"] = to_json(origin);
  json["layout"] = layout_json(layout, options);
  return OrderedJson{{"trivet", std::move(json)}}.dump();
}

std::string node_extras(const Scene& scene, const Object& object, const LoadSupport::Entry* entry,
                        const SceneFileOptions& options) {
  const std::string path = joined_path(options.model_folder, object.model->path);
  return OrderedJson{{"trivet", object_json(scene, object, entry, path)}}.dump();
}

TrivetExtras parse_scene_extras(const std::string& text, const std::string& file) {
  const nlohmann::json document = parse_json(text.empty() ? "{}" : text, file);
  const auto found = JsonPlace(document, file + " (extras of the scene)").find("trivet");
  if (!found)
    JsonPlace(document, file).fail("has no data of Trivet; accepted: scenes that Trivet wrote");
  const JsonPlace& root = *found;
  root.expect_object({"trivet", "version", "floor", "clearance", "models", "objects", "layout"},
                     {"load_support", "origin", "floor_material", "pair_rules", "floor_kind"});
  if (root.at("trivet").value() != kExtrasVersion)
    root.at("trivet").refuse(std::to_string(kExtrasVersion));

  TrivetExtras extras;
  extras.floor = root.at("floor").boolean();
  if (const auto material = root.find("floor_material"))
    extras.floor_material = read_material(*material);
  if (const auto rules = root.find("pair_rules")) extras.pair_rules = read_kind_rules(*rules);
  if (const auto kind = root.find("floor_kind")) extras.floor_kind = read_kind(*kind);
  extras.clearance = root.at("clearance").number(0, kMaxLength);
  if (const auto place = root.find("origin")) extras.origin = read_position(*place);
  for (const JsonPlace& item : root.at("models").items())
    extras.models.push_back(read_model_entry(item));
  for (const JsonPlace& item : root.at("objects").items())
    extras.objects.push_back(read_object_entry(item, extras.models.size()));
  extras.layout = parse_layout(root.at("layout").value().dump(), root.at("layout").where());
  extras.layout.settle = rules_of(with_rules(with_rules({}, kRulesBefore), extras.layout.settle));
  return extras;
}

bool has_trivet_extras(const std::string& text) {
  if (text.empty()) return false;
  const auto document = json_if_valid<nlohmann::json>(text);
  return document && document->is_object() && document->contains("trivet");
}

}  // namespace trivet
