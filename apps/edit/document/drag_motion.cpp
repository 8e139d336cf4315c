#include "apps/edit/document/drag_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ops/operations/push_axes.h"

namespace trivet::edit {
namespace {

constexpr double kLeastStep = 1e-6;  // of the object's size; shorter ways have no direction
constexpr double kLeastTurn = 1e-6;  // tan(angle / 2)

// The turn from one pose to the other, and on.
std::optional<Motion> turn_between(const Pose& from, const Pose& to) {
  const Rotation& r = from.rotation;
  const Rotation turn = to.rotation * Rotation{r.w, -r.x, -r.y, -r.z};
  const Vec3 sine = (turn.w < 0 ? -1 : 1) * Vec3(turn.x, turn.y, turn.z);
  const double s = sine.norm() / std::abs(turn.w);
  if (!(s > kLeastTurn && s < kInfinity)) return std::nullopt;
  const Vec3 axis = sine.normalized();
  const Vec3 way = to.translation - from.translation;
  const Vec3 across = way - axis.dot(way) * axis;
  const Vec3 middle = 0.5 * (to.translation + from.translation);
  return Motion::rotation(middle + axis.cross(across) / (2 * s), axis, 1);
}

}  // namespace

std::optional<Motion> motion_between(const Pose& from, const Pose& to, double size) {
  if (auto turn = turn_between(from, to)) return turn;
  const Vec3 way = to.translation - from.translation;
  if (!(way.norm() > kLeastStep * size)) return std::nullopt;
  return Motion::translation(way.normalized(), std::max(way.norm(), size));
}

DragMotion::DragMotion(const Operation& operation, const Pose& start, double size)
    : m_operation(operation), m_start(start), m_before(start), m_size(size) {}

std::optional<Motion> DragMotion::next(const Pose& now, const DragGoal& goal) {
  const bool turns = std::holds_alternative<TurnOperation>(m_operation) ||
                     std::holds_alternative<RotateOperation>(m_operation);
  const bool in_joint = std::holds_alternative<MoveJointOperation>(m_operation);
  std::optional<Motion> found;
  if (turns || in_joint) found = turn_between(m_before, now);
  if (!found && !turns) found = straight(now, goal);
  if (found) m_last = found;
  m_before = now;
  return m_last;
}

std::optional<Motion> DragMotion::straight(const Pose& now, const DragGoal& goal) const {
  const Vec3 moved = now.translation - m_before.translation;
  Vec3 way = Vec3::Zero();
  if (const auto* const push = std::get_if<PushOperation>(&m_operation); goal.to && push) {
    const Mat3 axes = push_axes(push->normal);
    const Vec2 left = goal.to->head<2>() - (axes * now.translation).head<2>();
    way = axes.transpose() * Vec3(left.x(), left.y(), 0);
  } else if (goal.to)
    way = m_start.translation + *goal.to - now.translation;
  const double least = kLeastStep * m_size;
  if (way.norm() > least)
    return Motion::translation(way.normalized(), std::max(way.norm(), m_size));
  if (moved.norm() > least) return Motion::translation(moved.normalized(), m_size);
  return std::nullopt;
}

}  // namespace trivet::edit
