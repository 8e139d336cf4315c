#include "ops/operations/turn.h"

#include "ops/operations/move_parts.h"
#include "ops/operations/table.h"

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

constexpr Accepts kAbout{Sort::Word, 0, 0, "", {"normal", "line", "point"}};

}  // namespace

template <>
const OperationTable& table<TurnOperation>() {
  using P = TurnOperation;
  using R = Row<P>;
  constexpr unsigned kLinePoint = 0, kNormal = 1;
  static const OperationTable rows = make_table<P>(
      {{"turn",
        "Turn an object about the line of a contact (of an area the edge nearest to the point), "
        "or about an axis through a contact point; it stops at collision",
        {"about"},
        {"line", "point"},
        [](const P& o) { return o.about != P::About::Normal; },
        [](P& o) { o.about = P::About::Line; }},
       {"turn",
        "Turn an object about the normal of a contact, which stays; it stops at collision"}},
      {R("about", &P::about, kAbout, "Part of the contact that is held").always_written(),
       R("with", &P::with, kSupportName,
         "Partner of the contact, \"floor\" too; default: the main support"),
       R("centre", &P::centre, kPoint, "A point on the axis; default: the contact's centre")
           .in({kNormal}),
       R("point", &P::point, kPoint,
         "The line or point nearest to it is held; default: the contact's "
         "centre")
           .in({kLinePoint}),
       R("axis", &P::axis, kDirection,
         "Axis through a point, default: the contact's normal; or direction along a line, default: "
         "in "
         "which the object's centre rises")
           .in({kLinePoint}),
       R("angle_deg", &P::angle_deg, kAngle, "Angle, right-handed about the axis").needed(),
       R("settle", &P::settle, kFlag, "Release the object at the end, so that it settles")});
  return rows;
}

std::optional<TurnAxis> axis_or_refusal(MovePlanner& planner, const TurnOperation& o) {
  const Scene& scene = planner.scene();
  const ObjectContact* entry = held_contact(scene, planner.group().object(), o.with);
  // Without a contact there is nothing to hold in the turn.
  if (!entry) {
    Refusal why{Refusal::Cause::NoContact, {planner.name()}};
    if (o.with) why.objects.push_back(named(scene, *o.with));
    why.detail = "to turn about";
    planner.refuse(why);
    return std::nullopt;
  }
  // A point has no line to turn about.
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
