#include "ops/operations/translate.h"

#include "ops/operations/move_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<TranslateOperation>() {
  using P = TranslateOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"translate", "Translate an object along a straight line, or several, up to a collision"}},
      {R("by", &P::by, kPoint, "Displacement from where it is").needed(),
       R("via", &P::via, kPoint,
         "Places on the way, as displacements from where it was at the start"),
       R("free", &P::free, kFlag,
         "Ignore collisions, as in a modeller; what interpenetrates then is marked invalid"),
       R("settle", &P::settle, kFlag, "Release the object at the end, so that it settles")});
  return rows;
}

void translate_group(MovePlanner& planner, const Vec3& offset, bool free) {
  MovingGroup& group = planner.group();
  // Displacements count from where the object was at first, whatever was in the way since.
  const Vec3 by = offset - (group.pose().translation - group.object().pose.translation);
  const double length = by.norm();
  planner.result().end = OperationResult::End::Reached;
  if (length == 0) return;
  const Motion motion = Motion::translation(by / length, length);
  if (free) {
    group.advance(motion, length);
    planner.note_step(SettleStep::Kind::Move);
  } else {
    planner.advance(motion, SettleStep::Kind::Move);
  }
}

MovePlan finish_move(MovePlanner& planner, bool free, bool settle) {
  // A free move settles only where nothing is crossed.
  const bool releases =
      settle && !planner.refused() &&
      (!free || !refuse_interpenetration(planner.scene(), planner.group().placements(), true));
  if (releases) planner.release();
  return free && !releases ? planner.finish_freely() : planner.finish(ObjectState::Held);
}

MovePlan plan(const Scene& scene, ObjectId id, const TranslateOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "translate", run, o.free);
  for (size_t i = 0; i <= o.via.size() && !planner.refused(); ++i)
    translate_group(planner, i < o.via.size() ? o.via[i] : o.by, o.free);
  return finish_move(planner, o.free, o.settle);
}

}  // namespace trivet
