#include "ops/operations/stand.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

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
  if (auto why = refuse_stand(scene, id, o.pose, run.options)) return refused(std::move(*why));
  const double clearance = clearance_of(scene, run.options, expected_box(scene, object, o.pose));
  std::vector<ObjectId> dependents;
  if (was_placed) dependents = dependents_of(scene, id);
  stand_at(transaction, id, o.pose, rest_rules(run.options, clearance));
  OperationResult result = done_result();
  leave_neighbours(transaction, dependents, o, "stand", named(scene, Support(id)), clearance, run,
                   result);
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

}  // namespace trivet
