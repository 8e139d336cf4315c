// TURN/TILT [Shinya 1995, 4.1, Fig. 5]: the contact that is held gives the axis.
#include "ops/move/move_parts.h"
#include "ops/move/moves.h"

namespace trivet {
namespace {

std::string name_of(const Scene& scene, const Link& link) {
  return link.with ? scene.at(*link.with).name : "floor";
}

// The contact that is asked for; else of those that support (or, if none does, of all) the one with
// the most contact. Null: there is none.
const Link* held_link(const Scene& scene, const Object& object,
                      const std::optional<std::string>& with) {
  const Link* best = nullptr;
  for (const Link& link : object.links)
    if (!with || name_of(scene, link) == *with)
      if (!best || holds_more(link, *best)) best = &link;
  return best;
}

}  // namespace

std::optional<TurnAxis> axis_or_refusal(Attempt& attempt, const TurnOperation& o) {
  const Link* link = held_link(attempt.scene(), attempt.group().object(), o.with);
  if (!link) {
    attempt.refuse(attempt.name() + " does not touch " +
                   (o.with ? "\"" + *o.with + "\"" : "anything") +
                   ": there is no contact to turn about");
    return std::nullopt;
  }
  if (o.about == TurnOperation::About::Line && link->contact.hull.size() < 2) {
    attempt.refuse(attempt.name() + " touches \"" + name_of(attempt.scene(), *link) +
                   "\" in one point: there is no line to turn about");
    return std::nullopt;
  }
  return turn_axis(attempt.group().object(), link->contact, o);
}

OperationResult finish_turn(Attempt& attempt, const TurnOperation& o) {
  if (o.settle && !attempt.refused()) attempt.let_go();
  return attempt.finish(ObjectState::Held);
}

OperationResult perform_turn(Scene& scene, ObjectId id, const TurnOperation& o,
                             const SettleOptions& options) {
  Attempt attempt(scene, id, o, "turn", options);
  if (attempt.refused()) return attempt.finish(ObjectState::Held);
  if (const auto axis = axis_or_refusal(attempt, o))
    rotate_group(attempt, axis->centre, axis->direction, o.angle_deg, false);
  return finish_turn(attempt, o);
}

}  // namespace trivet
