#include "ops/operations/stand.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr double kApart = 1.5;  // clearances between what touched; less than contacts have

bool is_interpenetration(const Refusal& why) {
  using enum Refusal::Cause;
  return why.cause == Crossing || why.cause == Float32Contact || why.cause == BelowFloor ||
         why.cause == Float32BelowFloor;
}

// The pose of an object that only touches others there, as flush walls do, moved apart from them:
// kApart clearances along one axis of the world, two or all three.
std::optional<Pose> moved_apart(const Scene& scene, ObjectId id, const Pose& pose,
                                double clearance) {
  // One axis is tried first, then two, then three: the shortest ways that part it.
  for (int num_axes = 1; num_axes <= 3; ++num_axes)
    for (int code = 0; code < 27; ++code) {
      const Vec3 way(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if (way.squaredNorm() != num_axes) continue;
      Pose apart = pose;
      apart.translation += kApart * clearance * way;
      if (!refuse_interpenetration(scene, id, apart, true)) return apart;
    }
  return std::nullopt;
}

}  // namespace

template <>
const OperationTable& table<StandOperation>() {
  using P = StandOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"stand",
        "Stand an object exactly at a pose: tested, but not settled; objects that it leaves are "
        "rated again"}},
      {R("position", &P::pose, &Pose::translation, kPoint, "Position of the model's origin")
           .needed(),
       R("rotation", &P::pose, &Pose::rotation, kRotation, "Rotation there, quaternion")
           .always_written()});
  return rows;
}

OperationResult apply(Transaction& transaction, const StandOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_named(transaction, o.object);
  const Object& object = scene.at(id);
  const bool was_placed = object.placed;
  if (object.locked) return refused(locked_refusal(scene, id));
  if (object.fixed && was_placed)
    return refused({Refusal::Cause::Fixed, {named(scene, Support(id))}});
  const PlacedBox expected{id, expected_box(scene, object, o.pose)};
  const double clearance = clearance_near(scene, run.options, expected.box, {&expected, 1});
  Pose pose = o.pose;
  // Objects in files often touch exactly; they are parted, and only real crossings are refused.
  if (auto why = refuse_stand(scene, id, pose, run.options)) {
    std::optional<Pose> apart;
    if (is_interpenetration(*why)) apart = moved_apart(scene, id, pose, clearance);
    if (!apart) return refused(std::move(*why));
    pose = *apart;
  }
  // Objects that it leaves are noted before it goes.
  std::vector<ObjectId> dependents;
  if (was_placed) dependents = dependents_of(scene, id);
  stand_at(transaction, id, pose, rest_rules(run.options, clearance));
  OperationResult result = done_result();
  result.moved = (pose.translation - o.pose.translation).norm();
  leave_neighbours(transaction, dependents, o, "stand", named(scene, Support(id)), clearance, run,
                   result);
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

}  // namespace trivet
