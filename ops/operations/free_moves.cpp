// PICK-UP, TRANSLATE and ROTATE [Shinya 1995, 4.1].
#include <algorithm>
#include <cmath>

#include "ops/operations/move_parts.h"

namespace trivet {
namespace {

constexpr double kQuarterTurnDeg = 90;
constexpr double kSmallestDirection = 1e-3;  // of summed-up unit normals: opposite ones cancel out

/// Direction away from the supports, or from one partner: the sum of the contacts' normals;
/// straight up where supports pinch the object, so that theirs cancel out. Zero: there is none.
Vec3 away_from_contacts(const Scene& scene, const MovingGroup& group,
                        const std::optional<std::string>& with) {
  Vec3 sum = Vec3::Zero();
  bool is_held = false;
  for (const ObjectContact& entry : group.object().contacts) {
    const std::string name = named(scene, entry.with).name;
    if (!(with ? name == *with : holds_up(entry))) continue;
    sum += entry.contact.normal;
    is_held |= holds_up(entry);
  }
  const double length = sum.norm();
  if (length > kSmallestDirection) return sum / length;
  return is_held ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Zero());
}

}  // namespace

void translate_group(MovePlanner& planner, const Vec3& offset, bool free) {
  MovingGroup& group = planner.group();
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
  const bool releases =
      settle && !planner.refused() &&
      (!free || !refuse_interpenetration(planner.scene(), planner.group().placements(), true));
  if (releases) planner.release();
  return free && !releases ? planner.finish_freely() : planner.finish(ObjectState::Held);
}

std::optional<Vec3> pick_up_direction(MovePlanner& planner, const PickUpOperation& o) {
  const Vec3 up = away_from_contacts(planner.scene(), planner.group(), o.with);
  if (up != Vec3::Zero()) return up;
  Refusal why{o.with ? Refusal::Cause::NoContact : Refusal::Cause::LiesOnNothing, {planner.name()}};
  if (o.with) why.objects.push_back(named(planner.scene(), *o.with));
  why.detail = "to pick it up from";
  planner.refuse(why);
  return std::nullopt;
}

void rotate_group(MovePlanner& planner, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free) {
  OperationResult& result = planner.result();
  result.end = OperationResult::End::Reached;
  const double sign = angle_deg < 0 ? -1 : 1;
  double left = std::abs(angle_deg);
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
    const bool whole = result.end == OperationResult::End::Reached;
    result.turned_deg += sign * (whole ? part : turned_deg(time));
    if (!whole) return;
    left -= part;
  }
}

MovePlan plan(const Scene& scene, ObjectId id, const PickUpOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "pick_up", run);
  if (planner.refused()) return planner.finish(ObjectState::Held);
  if (const auto up = pick_up_direction(planner, o))
    translate_group(planner, o.distance * *up, false);
  return planner.finish(ObjectState::Held);
}

MovePlan plan(const Scene& scene, ObjectId id, const TranslateOperation& o, OperationRun& run) {
  MovePlanner planner(scene, id, o, "translate", run, o.free);
  for (size_t i = 0; i <= o.via.size() && !planner.refused(); ++i)
    translate_group(planner, i < o.via.size() ? o.via[i] : o.by, o.free);
  return finish_move(planner, o.free, o.settle);
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
