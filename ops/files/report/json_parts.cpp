#include "ops/files/report/json_parts.h"

#include "ops/files/json/joint_json.h"
#include "ops/files/json/mass_json.h"
#include "ops/files/json/material_json.h"
#include "ops/files/report/flexible_json.h"
#include "ops/files/report/repaired.h"
#include "ops/files/report/verdict.h"
#include "ops/stability/weight.h"

namespace trivet {

OrderedJson to_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

OrderedJson to_json(const Affine& affine) {
  OrderedJson json = OrderedJson::array();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) json.push_back(affine.linear(r, c));
    json.push_back(affine.translation[r]);
  }
  for (const double last : {0.0, 0.0, 0.0, 1.0}) json.push_back(last);
  return json;
}

OrderedJson supports_json(const Scene& scene, const LoadSupport::Entry& entry) {
  OrderedJson json = OrderedJson::array();
  if (entry.on_floor) json.push_back("floor");
  for (const ObjectId id : entry.supports) json.push_back(scene.at(id).name);
  return json;
}

OrderedJson object_stability_json(const Scene& scene, const ObjectStability& o) {
  const Object& object = scene.at(o.object);
  OrderedJson json = {{"name", object.name},
                      {"weight", o.weight},
                      {"margin", o.margin},
                      {"marginal", o.marginal},
                      {"topples", o.topples},
                      {"least_friction", object.least_friction},
                      {"friction", least_pair_friction(scene, o.object)}};
  if (!o.topples) return json;
  json["way"] = way_text(object, o.motion);
  json["velocity"] = to_json(o.motion.velocity);
  json["spin"] = to_json(o.motion.spin);
  return json;
}

OrderedJson stability_json(const Scene& scene, const Stability& stability) {
  OrderedJson topples = OrderedJson::array(), objects = OrderedJson::array(),
              forces = OrderedJson::array();
  for (const ObjectStability& o : stability.objects) {
    const std::string& name = scene.at(o.object).name;
    if (o.topples) topples.push_back(name);
    objects.push_back(object_stability_json(scene, o));
  }
  for (const ContactForce& f : stability.forces)
    forces.push_back({{"on", scene.at(f.on).name},
                      {"from", named(scene, f.from).name},
                      {"point", to_json(f.point)},
                      {"force", to_json(f.force)}});
  OrderedJson json = {{"status", to_string(stability.status)},
                      {"method", to_string(stability.method)},
                      {"friction", stability.friction ? OrderedJson(*stability.friction)
                                                      : OrderedJson("materials")},
                      {"friction_of_a_pair", "smaller"},
                      {"residual", stability.residual},
                      {"margin", stability.margin},
                      {"topples", std::move(topples)},
                      {"objects", std::move(objects)},
                      {"forces", std::move(forces)}};
  if (!stability.why_unknown.empty()) json["why_unknown"] = stability.why_unknown;
  return json;
}

const char* to_string(OperationResult::Status status) {
  switch (status) {
    case OperationResult::Status::Ok:
      return "ok";
    case OperationResult::Status::Refused:
      return "refused";
    case OperationResult::Status::Cancelled:
      return "cancelled";
    case OperationResult::Status::OutOfTime:
      return "out of time";
  }
  return "?";
}

void add_refusal(const OperationResult& result, OrderedJson& json) {
  json["reason"] = result.reason();
  if (!result.refusal) return;
  json["cause"] = to_string(result.refusal->cause);
  OrderedJson objects = OrderedJson::array(), numbers = OrderedJson::object();
  for (const Named& object : result.refusal->objects) objects.push_back(object.name);
  for (const Refusal::Number& n : result.refusal->numbers) numbers[n.key] = n.value;
  if (!objects.empty()) json["objects"] = std::move(objects);
  if (!numbers.empty()) json["numbers"] = std::move(numbers);
}

void add_outcome(const OperationResult& result, OrderedJson& json) {
  json["ended"] = to_string(result.end);
  if (!result.blocked_by.name.empty()) {
    json["blocked_by"] = result.blocked_by.name;
    json["blocked_at"] = to_json(result.blocked_at);
  }
  if (const auto& tried = result.tried) {
    json["try"] = tried->number;
    json["start_shifted"] = tried->shifted;
    json["start_turned_deg"] = tried->turned_deg;
  }
  json["moved"] = result.moved;
  if (result.turned_deg != 0) json["turned_deg"] = result.turned_deg;
  if (result.joint_value) json["value"] = *result.joint_value;
  const auto add = [&](const char* key, const std::vector<std::string>& names) {
    if (!names.empty()) json[key] = names;
  };
  add("carried", result.carried);
  add("unsupported", result.unsupported);
  add("settled", result.settled);
  if (!result.gave_way.empty()) {
    OrderedJson objects = OrderedJson::array();
    for (const GaveWay& g : result.gave_way)
      objects.push_back({{"name", g.name}, {"moved", g.moved}, {"turned_deg", g.turned_deg}});
    json["gave_way"] = std::move(objects);
  }
  add("interpenetrates", result.interpenetrates);
  add("unsound_supports", result.unsound);
  if (result.repaired) json["repaired"] = repaired_json(*result.repaired);
}

OrderedJson contacts_json(const Scene& scene, const Object& object) {
  OrderedJson json = OrderedJson::array();
  for (const ObjectContact& link : object.contacts) {
    OrderedJson points = OrderedJson::array();
    for (const ContactPoint& p : link.contact.points) points.push_back(to_json(p.point));
    json.push_back({{"with", named(scene, link.with).name},
                    {"type", to_string(link.contact.type)},
                    {"points", std::move(points)},
                    {"normal", to_json(link.contact.normal)},
                    {"gap", link.contact.gap}});
  }
  return json;
}

OrderedJson object_json(const Scene& scene, const Object& object, const LoadSupport::Entry* entry,
                        const std::string& model_path) {
  OrderedJson json = {{"name", object.name},
                      {"model", model_path},
                      {"triangles", object.shape->mesh.triangles.size()}};
  const bool placed = object.placed;
  json["world_from_file"] = placed ? to_json(object.world_from_object()) : OrderedJson();
  json["centre_of_mass"] = placed ? to_json(object.centre_of_mass()) : OrderedJson();
  json["mass_rule"] = to_string(object.shape->mass.rule);
  json["material"] = whole_material_json(object.material);
  if (object.given_mass) json["mass"] = mass_json(*object.given_mass);
  json["kilograms"] = weight_of(object) / kGravity;
  json["state"] = to_string(object.state);
  json["supported_by"] = entry ? supports_json(scene, *entry) : OrderedJson::array();
  if (entry)
    for (const ObjectId id : unsound_supports(scene, entry->object))
      json["unsound_supports"].push_back(scene.at(id).name);
  json["contacts"] = placed ? contacts_json(scene, object) : OrderedJson::array();
  const bool rests = placed && !object.fixed;
  json["stability_margin"] = rests ? OrderedJson(object.stability_margin) : OrderedJson();
  json["least_friction"] = rests ? OrderedJson(object.least_friction) : OrderedJson();
  if (object.joint) json["joint"] = joint_json(named_joint(scene, *object.joint));
  if (object.flexible) json["flexible"] = flexible_json(*object.flexible);
  return json;
}

}  // namespace trivet
