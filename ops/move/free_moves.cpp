// PICK-UP, TRANSLATE and ROTATE [Shinya 1995, 4.1].
#include <cmath>

#include "ops/move/move_parts.h"
#include "ops/move/moves.h"

namespace trivet {
namespace {

constexpr double kQuarterTurnDeg = 90;
constexpr double kSmallestDirection = 1e-3;  // of summed-up unit normals: opposite ones cancel out

/// Away from what the contacts are with: the sum of their normals. Zero: there is none.
Vec3 away_from_contacts(const Scene& scene, const MovingGroup& group,
                        const std::optional<std::string>& with) {
  Vec3 sum = Vec3::Zero();
  for (const Link& link : group.object().links) {
    const std::string name = link.with ? scene.at(*link.with).name : "floor";
    if (with ? name == *with : holds_up(link.contact)) sum += link.contact.normal;
  }
  const double length = sum.norm();
  return length > kSmallestDirection ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

}  // namespace

void translate_group(Attempt& attempt, const Vec3& offset, bool free) {
  MovingGroup& group = attempt.group();
  const Vec3 by = offset - (group.pose().translation - group.object().pose.translation);
  const double length = by.norm();
  attempt.result().end = OperationResult::End::Reached;
  if (length == 0) return;
  const Motion motion = Motion::translation(by / length, length);
  if (free) {
    group.advance(motion, length);
    attempt.note_step(SettleStep::Kind::Move);
  } else {
    attempt.advance(motion, SettleStep::Kind::Move);
  }
}

OperationResult finish_move(Attempt& attempt, bool free, bool settle) {
  const bool lets_go =
      settle && !attempt.refused() &&
      (!free || why_invalid(attempt.scene(), attempt.group().placements(), true).empty());
  if (lets_go) attempt.let_go();
  return free && !lets_go ? attempt.finish_freely() : attempt.finish(ObjectState::Held);
}

std::optional<Vec3> pick_up_direction(Attempt& attempt, const PickUpOperation& o) {
  const Vec3 up = away_from_contacts(attempt.scene(), attempt.group(), o.with);
  if (up != Vec3::Zero()) return up;
  attempt.refuse(attempt.name() +
                 (o.with ? " does not touch \"" + *o.with + "\"" : " lies on nothing") +
                 ": there is no contact to pick it up from");
  return std::nullopt;
}

void rotate_group(Attempt& attempt, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free) {
  OperationResult& result = attempt.result();
  result.end = OperationResult::End::Reached;
  const double sign = angle_deg < 0 ? -1 : 1;
  double left = std::abs(angle_deg);
  while (left > 0 && !attempt.refused() && !attempt.interrupted()) {
    const double part = std::min(left, kQuarterTurnDeg);
    const Motion motion = Motion::rotation(centre, sign * axis, turn_time(part));
    double time = motion.limit;
    if (free) {
      attempt.group().advance(motion, time);
      attempt.note_step(SettleStep::Kind::Turn);
    } else {
      time = attempt.advance(motion, SettleStep::Kind::Turn);
    }
    const bool whole = result.end == OperationResult::End::Reached;
    result.turned_deg += sign * (whole ? part : turned_deg(time));
    if (!whole) return;
    left -= part;
  }
}

OperationResult perform_pick_up(Scene& scene, ObjectId id, const PickUpOperation& o,
                                const SettleOptions& options) {
  Attempt attempt(scene, id, o, "pick_up", options);
  if (attempt.refused()) return attempt.finish(ObjectState::Held);
  if (const auto up = pick_up_direction(attempt, o))
    translate_group(attempt, o.distance * *up, false);
  return attempt.finish(ObjectState::Held);
}

OperationResult perform_translate(Scene& scene, ObjectId id, const TranslateOperation& o,
                                  const SettleOptions& options) {
  Attempt attempt(scene, id, o, "translate", options, o.free);
  for (size_t i = 0; i <= o.via.size() && !attempt.refused(); ++i)
    translate_group(attempt, i < o.via.size() ? o.via[i] : o.by, o.free);
  return finish_move(attempt, o.free, o.settle);
}

OperationResult perform_rotate(Scene& scene, ObjectId id, const RotateOperation& o,
                               const SettleOptions& options) {
  Attempt attempt(scene, id, o, "rotate", options, o.free);
  if (!attempt.refused()) {
    const Vec3 centre = o.centre.value_or(attempt.group().centre());
    rotate_group(attempt, centre, o.axis.normalized(), o.angle_deg, o.free);
  }
  return finish_move(attempt, o.free, o.settle);
}

}  // namespace trivet
