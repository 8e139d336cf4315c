#include "ops/arrange/steadiness.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "ops/placement/clearance.h"
#include "ops/settle/rest.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

// The object and all that lies on it, whole, though it may lie on others, too.
std::vector<ObjectId> with_loads(const Scene& scene, ObjectId id) {
  std::vector<ObjectId> out{id};
  // Loads of loads count, too.
  for (size_t i = 0; i < out.size(); ++i)
    for (const ObjectContact& entry : scene.at(out[i]).contacts) {
      if (!entry.with.is_object() || !weighs_on(entry)) continue;
      const ObjectId load = entry.with.object();
      if (!scene.at(load).fixed && !std::count(out.begin(), out.end(), load)) out.push_back(load);
    }
  return out;
}

// Margin of the first of these, with the weight of all where their common centre of mass is.
double common_margin(const World& world, const std::vector<ObjectId>& all) {
  const Scene& scene = world.scene();
  double weight = 0;
  Vec3 moment = Vec3::Zero();
  for (const ObjectId id : all) {
    const double own = weight_of(scene.at(id));
    weight += own;
    moment += own * scene.at(id).centre_of_mass();
  }
  const Object& object = scene.at(all.front());
  std::vector<ContactsWith> below = linked_contacts(object);
  // Contacts within the heap carry nothing together.
  std::erase_if(below, [&](const ContactsWith& c) {
    return c.with.is_object() && std::count(all.begin(), all.end(), c.with.object());
  });
  const SettleOptions& settle = world.setting().settle;
  return tipping_margin(
      scene, object, moment / weight, below,
      rest_rules(settle, clearance_near(scene, settle, scene.world_box(all.front()))));
}

// @param all  the object first, then what lies on it.
std::optional<Sentence> unsteady(const World& world, const std::vector<ObjectId>& all,
                                 const Steadiness& wanted) {
  const Object& object = world.scene().at(all.front());
  // The object may be steady alone, and not with what lies on it.
  const double common = all.size() > 1 && wanted.margin > 0 ? common_margin(world, all) : kInfinity;
  const double margin = std::min(object.stability_margin, common);
  const std::string name = quoted(object.name);
  if (margin < wanted.margin)
    return say(
        common < object.stability_margin
            ? TRIVET_SENTENCE("%1 would not stand well: it tips, with what lies on it, over an "
                              "edge %2 m away; accepted: %3 m or more")
            : TRIVET_SENTENCE("%1 would not stand well: it tips over an edge %2 m away; "
                              "accepted: %3 m or more"),
        name, figure(margin, 4), figure(wanted.margin, 4));
  if (object.least_friction > wanted.friction)
    return say("%1 would not stand well: it needs friction of %2; accepted: %3 or less", name,
               figure(object.least_friction, 4), figure(wanted.friction, 4));
  return std::nullopt;
}

}  // namespace

std::optional<Sentence> unsteady(const World& world, const ThingModel& thing) {
  const Scene& scene = world.scene();
  for (const Steadiness& wanted : world.arrangement().steadiness)
    for (const std::string& name : wanted.things) {
      if (!world.stands(name)) continue;
      const std::vector<ObjectId> all = with_loads(scene, *scene.find(name));
      if (!std::count(all.begin(), all.end(), thing.id)) continue;
      if (auto why = unsteady(world, all, wanted)) return why;
    }
  return std::nullopt;
}

}  // namespace trivet
