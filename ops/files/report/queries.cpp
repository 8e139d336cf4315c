#include "ops/files/report/queries.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/quoted.h"
#include "ops/files/report/json_parts.h"
#include "ops/files/report/verdict.h"
#include "ops/operations/carried_with.h"

namespace trivet {
namespace {

template <class Predicate>
std::vector<TouchedBy> contacts_where(const Scene& scene, ObjectId object, Predicate&& wanted) {
  std::vector<TouchedBy> out;
  for (const ObjectContact& entry : scene.at(object).contacts)
    if (wanted(entry)) out.push_back({entry.with, &entry.contact});
  return out;
}

OrderedJson touched_json(const Scene& scene, const std::vector<TouchedBy>& touched) {
  OrderedJson json = OrderedJson::array();
  for (const TouchedBy& t : touched) {
    OrderedJson points = OrderedJson::array(), hull = OrderedJson::array();
    for (const ContactPoint& p : t.contact->points) points.push_back(to_json(p.point));
    for (const Vec3& p : t.contact->hull) hull.push_back(to_json(p));
    json.push_back({{"name", named(scene, t.with).name},
                    {"type", to_string(t.contact->type)},
                    {"points", std::move(points)},
                    {"hull", std::move(hull)},
                    {"normal", to_json(t.contact->normal)},
                    {"gap", t.contact->gap}});
  }
  return json;
}

std::string names_of(const Scene& scene, const std::vector<TouchedBy>& touched) {
  std::string out;
  for (const TouchedBy& t : touched) {
    out += out.empty() ? "" : ", ";
    out += t.with.is_object() ? quoted(named(scene, t.with).name) : "the floor";
    out += std::string(" (") + to_string(t.contact->type) + ")";
  }
  return out.empty() ? "nothing" : out;
}

const ObjectStability* find(const Stability& part, ObjectId object) {
  for (const ObjectStability& o : part.objects)
    if (o.object == object) return &o;
  return nullptr;
}

OrderedJson with_all_free_json(const Scene& scene, const Stability& part,
                               const ObjectStability& o) {
  OrderedJson json = object_stability_json(scene, o);
  json.erase("name");
  json["stable"] = part.stable();
  json["forces"] = OrderedJson::array();
  for (const ContactForce& f : part.forces)
    if (f.on == o.object)
      json["forces"].push_back({{"from", named(scene, f.from).name},
                                {"point", to_json(f.point)},
                                {"force", to_json(f.force)}});
  return json;
}

// Rounding leaves parts that are no force.
std::string newtons(const Vec3& force) {
  const double least = 1e-9 * force.cwiseAbs().maxCoeff();
  std::ostringstream out;
  for (const double part : force) out << (std::abs(part) <= least ? 0.0 : part) << " ";
  return out.str() + "N";
}

// Forces of the neighbours, in the order in which they are met.
std::string forces_text(const Scene& scene, const Stability& part, ObjectId object) {
  std::vector<std::pair<Support, Vec3>> sums;
  for (const ContactForce& f : part.forces) {
    if (f.on != object) continue;
    const auto it = std::find_if(sums.begin(), sums.end(),
                                 [&](const auto& sum) { return sum.first == f.from; });
    if (it == sums.end())
      sums.emplace_back(f.from, f.force);
    else
      it->second += f.force;
  }
  std::ostringstream out;
  for (const auto& [from, force] : sums)
    out << "    " << (from.is_object() ? quoted(named(scene, from).name) : "the floor")
        << " presses with " << newtons(force) << "\n";
  return out.str();
}

}  // namespace

std::vector<TouchedBy> held_by(const Scene& scene, ObjectId object) {
  return contacts_where(scene, object, [](const ObjectContact& entry) { return holds_up(entry); });
}

std::vector<TouchedBy> lying_on(const Scene& scene, ObjectId object) {
  return contacts_where(scene, object, [](const ObjectContact& entry) {
    return entry.with.is_object() && weighs_on(entry);
  });
}

RestOfObject rest_of(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  return {object.state == ObjectState::Stable || object.state == ObjectState::Fixed,
          object.stability_margin, object.least_friction};
}

std::string object_query_json(const Scene& scene, ObjectId id, const StabilityOptions& options) {
  const Object& object = scene.at(id);
  const RestOfObject rest = rest_of(scene, id);
  OrderedJson json = {{"name", object.name},
                      {"state", to_string(object.state)},
                      {"held_by", touched_json(scene, held_by(scene, id))},
                      {"lying_on", touched_json(scene, lying_on(scene, id))}};
  json["carries"] = OrderedJson::array();
  for (const ObjectId with : carried_with(scene, id))
    if (with != id) json["carries"].push_back(scene.at(with).name);
  json["at_rest"] = rest.at_rest;
  json["stability_margin"] = rest.margin;
  json["least_friction"] = rest.least_friction;
  const Stability part = stability_of_part(scene, id, options);
  if (const ObjectStability* o = find(part, id))
    json["with_all_free"] = with_all_free_json(scene, part, *o);
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string object_query_text(const Scene& scene, ObjectId id, const StabilityOptions& options) {
  const Object& object = scene.at(id);
  std::ostringstream out;
  out << "\"" << object.name << "\": " << to_string(object.state) << "\n"
      << "  held by: " << names_of(scene, held_by(scene, id)) << "\n"
      << "  lying on it: " << names_of(scene, lying_on(scene, id)) << "\n"
      << "  carries: " << carried_with(scene, id).size() - 1 << "\n";
  if (!object.placed || object.fixed) return out.str();
  if (object.state == ObjectState::Invalid) return out.str() + "  interpenetrates something\n";
  out << "  margin to tipping: " << object.stability_margin
      << " m; least friction: " << object.least_friction << ", its contacts have "
      << least_pair_friction(scene, id) << "\n";
  const Stability part = stability_of_part(scene, id, options);
  if (const ObjectStability* o = find(part, id)) {
    out << "  with everything let go: ";
    if (o->topples)
      out << "topples: " << way_text(object, o->motion) << "\n";
    else
      out << to_string(part.status) << ", margin " << o->margin << " m\n"
          << "    weight " << o->weight << " N\n"
          << forces_text(scene, part, id);
  }
  return out.str();
}

}  // namespace trivet
