// TURN/TILT [Shinya 1995, 4.1, Fig. 5]: the contact that is held gives the axis.
#include "ops/operations/move_parts.h"

namespace trivet {
namespace {

// The contact that is asked for; else the one that holds most. Null: there is none.
const ObjectContact* held_contact(const Scene& scene, const Object& object,
                                  const std::optional<std::string>& with) {
  const ObjectContact* best = nullptr;
  for (const ObjectContact& entry : object.contacts)
    if (!with || named(scene, entry.with).name == *with)
      if (!best || holds_more(entry, *best)) best = &entry;
  return best;
}

}  // namespace

std::optional<TurnAxis> axis_or_refusal(MovePlanner& planner, const TurnOperation& o) {
  const Scene& scene = planner.scene();
  const ObjectContact* entry = held_contact(scene, planner.group().object(), o.with);
  if (!entry) {
    Refusal why{Refusal::Cause::NoContact, {planner.name()}};
    if (o.with) why.objects.push_back(named(scene, *o.with));
    why.detail = "to turn about";
    planner.refuse(why);
    return std::nullopt;
  }
  if (o.about == TurnOperation::About::Line && entry->contact.hull.size() < 2) {
    planner.refuse({Refusal::Cause::PointContact, {planner.name(), named(scene, entry->with)}});
    return std::nullopt;
  }
  return turn_axis(planner.group().object(), entry->contact, o);
}

MovePlan finish_turn(MovePlanner& planner, const TurnOperation& o) {
  if (o.settle && !planner.refused()) planner.release();
  return planner.finish(ObjectState::Held);
}

MovePlan plan(const Scene& scene, ObjectId id, const TurnOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "turn", run);
  if (planner.refused()) return planner.finish(ObjectState::Held);
  if (const auto axis = axis_or_refusal(planner, o))
    rotate_group(planner, axis->centre, axis->direction, o.angle_deg, false);
  return finish_turn(planner, o);
}

}  // namespace trivet
