#include "ops/operations/put.h"

#include <algorithm>

#include "core/base/tunables.h"

namespace trivet {
namespace {

// A start that touches the floor is raised by as much as motions keep clear of it.
Pose clear_of_floor(const Scene& scene, const Object& object, Pose pose, double clearance) {
  if (!scene.floor) return pose;
  const Affine world = world_from_object(pose, object.up, object.scale);
  double lowest = kInfinity;
  for (const Vec3& v : object.shape->mesh.vertices) lowest = std::min(lowest, world.apply(v).z());
  if (lowest < kSeparateBelow * clearance) pose.translation.z() += clearance - lowest;
  return pose;
}

}  // namespace

MovePlan plan_put_from_start(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const EndCondition& refuse_end) {
  MovePlanner planner(scene, id, o, o.start, run);
  if (planner.refused()) return planner.finish(ObjectState::Stable);
  MovingGroup& group = planner.group();
  group.place(o.start);
  if (auto why = refuse_interpenetration(scene, group.placements(), false)) {
    why->at = Refusal::At::Start;
    planner.refuse(*why);
    return planner.finish(ObjectState::Stable);
  }
  group.place(clear_of_floor(scene, group.object(), o.start, group.clearance()));
  planner.release();
  if (!planner.refused() && refuse_end)
    if (const auto why = refuse_end(group)) planner.refuse(*why);
  return planner.finish(ObjectState::Stable);
}

MovePlan plan(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run) {
  return o.place ? plan_put_where_free(scene, id, o, run)
                 : plan_put_from_start(scene, id, o, run, {});
}

std::optional<Pose> start_of_put(const Operation& operation, const OperationResult& result,
                                 std::span<const SettleStep> steps) {
  const auto* const put = std::get_if<PutOperation>(&operation);
  if (!put) return std::nullopt;
  if (result.tried) return result.tried->start;
  if (!put->place) return put->start;
  if (steps.empty() || steps.front().kind != SettleStep::Kind::Fall) return std::nullopt;
  Pose start = steps.front().pose_after;
  start.translation.z() += steps.front().energy_drop;
  return start;
}

}  // namespace trivet
