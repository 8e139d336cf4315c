#include "ops/arrange/steadiness.h"

#include <algorithm>

#include "core/base/quoted.h"

namespace trivet {
namespace {

bool is_carried_by(const Object& object, ObjectId other) {
  return std::any_of(object.contacts.begin(), object.contacts.end(), [&](const ObjectContact& c) {
    return c.with == Support(other) && holds_up(c.contact);
  });
}

std::optional<std::string> unsteady(const Object& object, const Steadiness& wanted) {
  char text[96];
  if (object.stability_margin < wanted.margin)
    std::snprintf(text, sizeof(text), "it tips over an edge %.4g m away; accepted: %.4g m or more",
                  object.stability_margin, wanted.margin);
  else if (object.least_friction > wanted.friction)
    std::snprintf(text, sizeof(text), "it needs friction of %.4g; accepted: %.4g or less",
                  object.least_friction, wanted.friction);
  else
    return std::nullopt;
  return quoted(object.name) + " would not stand well: " + text;
}

}  // namespace

std::optional<std::string> unsteady(const World& world, const ThingModel& thing) {
  const Scene& scene = world.scene();
  for (const Steadiness& wanted : world.arrangement().steadiness)
    for (const std::string& name : wanted.things) {
      if (!world.stands(name)) continue;
      const ObjectId id = *scene.find(name);
      if (id != thing.id && !is_carried_by(world.object(thing), id)) continue;
      if (auto why = unsteady(scene.at(id), wanted)) return why;
    }
  return std::nullopt;
}

}  // namespace trivet
