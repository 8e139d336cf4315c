#include "ops/put.h"

#include <algorithm>
#include <utility>

#include "core/base/tunables.h"
#include "ops/move/attempt.h"
#include "ops/move/moves.h"
#include "ops/rest.h"
#include "ops/stopwatch.h"
#include "ops/verify.h"

namespace trivet {
namespace {

// A start that touches the floor is raised by as much as motions keep clear of it.
Pose clear_of_floor(const Scene& scene, const Object& object, Pose pose, double clearance) {
  if (!scene.floor) return pose;
  const Affine world = world_from_object(pose, object.up, object.scale);
  double lowest = kInfinity;
  for (const Vec3& v : object.shape->mesh.vertices) lowest = std::min(lowest, world.apply(v).z());
  if (lowest < kLiftBelow * clearance) pose.translation.z() += clearance - lowest;
  return pose;
}

}  // namespace

OperationResult put_from_start(Scene& scene, ObjectId id, const PutOperation& o,
                               const SettleOptions& options, const EndCondition& why_not) {
  Attempt attempt(scene, id, o, o.start, options);
  if (attempt.refused()) return attempt.finish(ObjectState::Stable);
  MovingGroup& group = attempt.group();
  group.place(o.start);
  const std::string why = why_invalid(scene, group.placements(), false);
  if (!why.empty()) {
    attempt.refuse("at its start position " + why);
  } else {
    group.place(clear_of_floor(scene, group.object(), o.start, group.clearance()));
    attempt.let_go();
    const std::string wrong = attempt.refused() || !why_not ? "" : why_not(group);
    if (!wrong.empty()) attempt.refuse(wrong);
  }
  return attempt.finish(ObjectState::Stable);
}

OperationResult perform_put(Scene& scene, ObjectId id, const PutOperation& o,
                            const SettleOptions& options) {
  return o.place ? put_somewhere(scene, id, o, options) : put_from_start(scene, id, o, options, {});
}

OperationResult put(Scene& scene, ObjectId id, const Pose& start, const SettleOptions& options) {
  return perform_put(scene, id, PutOperation{{std::as_const(scene).at(id).name}, start, {}},
                     options);
}

OperationResult stand(Scene& scene, ObjectId id, const Pose& pose, const SettleOptions& options) {
  OperationResult result;
  const Stopwatch stopwatch;
  const Object& object = std::as_const(scene).at(id);
  const double usual = default_clearance(scene, expected_box(scene, object, pose));
  const double clearance = options.clearance > 0 ? options.clearance : usual;
  const Placement stands{id, pose};
  std::string why = why_too_coarse(scene, {&stands, 1}, options.clearance);
  if (why.empty()) why = why_not_clearance(clearance, usual);
  if (why.empty()) {
    why = why_invalid(scene, id, pose, true);
    if (!why.empty()) why = "at its position " + why;
  }
  if (!why.empty()) {
    result.status = OperationResult::Status::Refused;
    result.reason = why;
    return result;
  }
  const Surroundings others(scene, id);
  ObjectState state = ObjectState::Fixed;
  if (!object.fixed)
    state = rests_at(object, pose, others, clearance) ? ObjectState::Stable : ObjectState::Wedged;
  const auto contacts = touching(object, pose, others, clearance);
  commit(scene, id, pose, state, others, contacts, clearance);
  result.milliseconds = stopwatch.milliseconds();
  return result;
}

const char* to_string(OperationResult::End end) {
  switch (end) {
    case OperationResult::End::Done:
      return "done";
    case OperationResult::End::AtRest:
      return "at_rest";
    case OperationResult::End::Reached:
      return "reached";
    case OperationResult::End::Blocked:
      return "blocked";
    case OperationResult::End::Step:
      return "step";
    case OperationResult::End::Edge:
      return "edge";
  }
  return "?";
}

}  // namespace trivet
