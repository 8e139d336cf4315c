#include "ops/operations/put.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "ops/operations/put_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

// A start that touches the floor is raised by as much as motions keep clear of it.
Pose clear_of_floor(const Scene& scene, const Object& object, Pose pose, double clearance) {
  // Vertices decide, as the floor is flat.
  if (!scene.floor) return pose;
  const Affine world = world_from_object(pose, object.up, object.scale);
  double lowest = kInfinity;
  for (const Vec3& v : object.shape->mesh.vertices) lowest = std::min(lowest, world.apply(v).z());
  if (lowest < kSeparateBelow * clearance) pose.translation.z() += clearance - lowest;
  return pose;
}

constexpr Accepts kAnywhere{Sort::Coordinates, -kMaxLength, kMaxLength, "metres", {"anywhere"}};
constexpr Accepts kFriction{Sort::Number, kMinFriction, kMaxFriction, "", {}, kInfinity};
constexpr Accepts kTries{Sort::Whole, 1, kMaxTriesOfPut};
constexpr Accepts kSizes{Sort::Number, 0, kMaxWithin};

std::optional<InvalidArgument> refuse_tries_of_place(const PutOperation& o) {
  if (!o.place || o.tries == 1 || o.tries == kTriesOfPut) return std::nullopt;
  return InvalidArgument{"tries", std::to_string(o.tries), "1 where a place is searched for"};
}

constexpr unsigned kOn = 0, kFrom = 1;

std::vector<Row<PutOperation>> put_rows() {
  using P = PutOperation;
  using R = Row<P>;
  return {
      R("position", &P::start, &Pose::translation, kPoint,
        "Position of the model's origin from which it falls")
          .in({kFrom})
          .needed(),
      R("on", &P::place, &PlaceOptions::on, kSupportName,
        "Support, an object or \"floor\", on which a free place is searched")
          .in({kOn})
          .needed(),
      R("at", &P::place, &PlaceOptions::near, kAnywhere,
        "Anywhere, or the free place nearest to a point, by the centre of mass seen from above "
        "when it is let go. Gaps with less than a few hundredths of the object's width to spare "
        "may not be found")
          .in({kOn})
          .always_written(),
      R("seed", &P::place, &PlaceOptions::seed, kSeed,
        "Number that selects the place, for anywhere")
          .in({kOn}),
      R("keep", &P::place, &PlaceOptions::keep, kLength,
        "Distance to everything but what it lies on and the floor")
          .in({kOn}),
      R("from", &P::place, &PlaceOptions::from, kHeight,
        "Height z from which it falls, whatever is above; default: just above its support")
          .in({kOn}),
      R("region", &P::place, &PlaceOptions::region, kRegion,
        "Region that holds its outline at rest, seen from above: two opposite corners of a "
        "rectangle, or corners of a convex polygon, counter-clockwise")
          .in({kOn}),
      R("least_margin", &P::place, &PlaceOptions::least_margin, kLength,
        "Least distance of its centre of mass from where it would tip, seen from above, at rest; "
        "other places are tried")
          .in({kOn}),
      R("most_friction", &P::place, &PlaceOptions::most_friction, kFriction,
        "Largest Coulomb coefficient that it may need to stay there; other places are tried; "
        "default: any")
          .in({kOn}),
      R("rotation", &P::start, &Pose::rotation, kRotation, "Rotation at the start, quaternion")
          .always_written(),
      R("tries", &P::tries, kTries,
        "Number of starts to try: where the object would topple or be wedged, it is turned about "
        "the vertical, moved, and let fall again, in the same container")
          .in({kFrom}),
      R("within", &P::within, kSizes,
        "Largest distance of these starts from the position, as a share of the object's size")
          .in({kFrom})};
}

}  // namespace

template <>
const OperationTable& table<PutOperation>() {
  using P = PutOperation;
  static const OperationTable rows = make_table<P>(
      {{"put",
        "Let an object fall where there is room, at a place where it comes to rest on one support "
        "alone",
        {"on", "at"},
        {},
        [](const P& o) { return o.place.has_value(); },
        [](P& o) { o.place.emplace(); }},
       {"put",
        "Let an object fall from a position along gravity to the first contact, then settle",
        {"position"}}},
      put_rows(), refuse_tries_of_place,
      TRIVET_SENTENCE("a place is missing; accepted: \"position\", from where it falls, or \"on\", "
                      "an object or \"floor\", on which a place is found"));
  return rows;
}

MovePlan plan_put_from_start(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const EndCondition& refuse_end) {
  MovePlanner planner(scene, id, o, o.start, run);
  if (planner.refused()) return planner.finish(ObjectState::Stable);
  MovingGroup& group = planner.group();
  // The object and its loads go to the start as a group.
  group.place(o.start);
  if (auto why = refuse_interpenetration(scene, group.placements(), false)) {
    why->at = Refusal::At::Start;
    planner.refuse(*why);
    return planner.finish(ObjectState::Stable);
  }
  // A start that touches the floor may fall all the same.
  group.place(clear_of_floor(scene, group.object(), o.start, group.clearance()));
  planner.release();
  if (!planner.refused() && refuse_end)
    if (const auto why = refuse_end(group)) planner.refuse(*why);
  return planner.finish(ObjectState::Stable);
}

MovePlan plan(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run) {
  return plan_put(scene, id, o, run, {});
}

MovePlan plan_put(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run,
                  const TryCommit& try_commit) {
  return o.place ? plan_put_where_free(scene, id, o, run, try_commit)
                 : plan_put_from_start(scene, id, o, run, {});
}

std::optional<Pose> start_of_put(const Operation& operation, const OperationResult& result,
                                 std::span<const SettleStep> steps) {
  const auto* const put = std::get_if<PutOperation>(&operation);
  if (!put) return std::nullopt;
  if (result.tried) return result.tried->start;
  if (!put->place) return put->start;
  if (steps.empty() || steps.front().kind != SettleStep::Kind::Fall) return std::nullopt;
  // The start is that of the fall, which ended where the first step did.
  Pose start = steps.front().pose_after;
  start.translation.z() += steps.front().energy_drop;
  return start;
}

}  // namespace trivet
