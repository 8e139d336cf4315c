#include "ops/operations/push.h"

#include "ops/operations/push_axes.h"
#include "ops/operations/push_events.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<PushOperation>() {
  using P = PushOperation;
  using R = Row<P>;
  constexpr unsigned kTo = 0, kAlong = 1;
  static const OperationTable rows = make_table<P>(
      {{"push",
        "Push an object along the surface on which it lies to a point, up and down low steps; "
        "its loads come along",
        {"to"},
        {},
        [](const P& o) { return o.to.has_value(); },
        [](P& o) { o.to.emplace(); }},
       {"push",
        "Push an object along the surface on which it lies, up and down low steps; its loads "
        "come along",
        {"direction", "distance"}}},
      {R("to", &P::to, kPoint, "Target of the object's position, seen from above")
           .in({kTo})
           .needed(),
       R("via", &P::via, kPoint, "Places on the way to the target, one after another").in({kTo}),
       R("direction", &P::direction, kDirection,
         "Direction, seen from above, of any length but zero")
           .in({kAlong})
           .needed(),
       R("distance", &P::distance, kLength, "Distance along the direction, seen from above")
           .in({kAlong})
           .needed(),
       R("normal", &P::normal, kDirection,
         "Normal of the surface, towards the object: along a wall, directions and targets are to "
         "the "
         "right and up, seen from the object; under a ceiling x and -y"),
       R("step_up", &P::step_up, kLength,
         "Height of the highest step that the object climbs; higher ones stop it"),
       R("step_down", &P::step_down, kLength,
         "Depth of the deepest edge that it goes down; it stops before deeper ones"),
       R("slide", &P::slide, kFlag, "Slide along walls; otherwise they stop the object")
           .otherwise("Stop at walls instead of sliding along them"),
       R("settle", &P::settle, kFlag,
         "Release the object at the end, so that it settles; otherwise it is held")
           .otherwise("Hold the object at the end instead of settling it")},
      nullptr,
      TRIVET_SENTENCE("a target is missing; accepted: \"to\", or \"direction\" and \"distance\""));
  return rows;
}

MovePlan plan(const Scene& scene, ObjectId id, const PushOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "push", run);
  if (planner.refused()) return planner.finish(ObjectState::Held);
  const MovingGroup& group = planner.group();
  Push push(planner, o);
  if (planner.refused()) return planner.finish(ObjectState::Held);
  // The way is given in axes of the surface: seen from above on a floor, seen from the front on a
  // wall.
  const Vec2 start = in_push_axes(o.normal, group.pose().translation).head<2>();
  const Vec2 goal = o.to.value_or(start + o.distance * o.direction.normalized());
  for (size_t i = 0; i <= o.via.size() && !planner.refused(); ++i)
    push.push_to(i < o.via.size() ? o.via[i] : goal);
  return push.finish();
}

}  // namespace trivet
