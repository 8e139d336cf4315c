#include "ops/operations/rotate.h"

#include <algorithm>
#include <cmath>

#include "ops/operations/move_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr double kQuarterTurnDeg = 90;

}  // namespace

template <>
const OperationTable& table<RotateOperation>() {
  using P = RotateOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"rotate", "Rotate an object about any axis, up to a collision"}},
      {R("axis", &P::axis, kDirection, "Axis of rotation, of any length but zero").needed(),
       R("angle_deg", &P::angle_deg, kAngle, "Angle, right-handed about the axis").needed(),
       R("centre", &P::centre, kPoint, "A point on the axis; default: the centre of mass"),
       R("free", &P::free, kFlag,
         "Ignore collisions, as in a modeller; what interpenetrates then is marked invalid"),
       R("settle", &P::settle, kFlag, "Release the object at the end, so that it settles")});
  return rows;
}

void rotate_group(MovePlanner& planner, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free) {
  OperationResult& result = planner.result();
  result.end = OperationResult::End::Reached;
  const double sign = angle_deg < 0 ? -1 : 1;
  double left = std::abs(angle_deg);
  // A turn goes in quarters, as motions do, and ends at the first contact.
  while (left > 0 && !planner.refused() && !planner.interrupted()) {
    const double part = std::min(left, kQuarterTurnDeg);
    const Motion motion = Motion::rotation(centre, sign * axis, turn_time(part));
    double time = motion.limit;
    if (free) {
      planner.group().advance(motion, time);
      planner.note_step(SettleStep::Kind::Turn);
    } else {
      time = planner.advance(motion, SettleStep::Kind::Turn);
    }
    // The angle that was reached is told, not that which was asked for.
    const bool whole = result.end == OperationResult::End::Reached;
    result.turned_deg += sign * (whole ? part : turned_deg(time));
    if (!whole) return;
    left -= part;
  }
}

MovePlan plan(const Scene& scene, ObjectId id, const RotateOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "rotate", run, o.free);
  if (!planner.refused()) {
    const Vec3 centre = o.centre.value_or(planner.group().centre());
    rotate_group(planner, centre, o.axis.normalized(), o.angle_deg, o.free);
  }
  return finish_move(planner, o.free, o.settle);
}

}  // namespace trivet
