#include "apps/edit/document/drag_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet::edit {
namespace {

constexpr double kLeastStep = 1e-6;  // of the object's size; shorter ways have no direction
constexpr double kLeastTurn = 1e-6;  // tan(angle / 2)

}  // namespace

DragMotion::DragMotion(const Operation& operation, const Pose& start, double size)
    : m_operation(operation), m_start(start), m_before(start), m_size(size) {}

std::optional<Motion> DragMotion::next(const Pose& now, const DragGoal& goal) {
  const bool turns = std::holds_alternative<TurnOperation>(m_operation) ||
                     std::holds_alternative<RotateOperation>(m_operation);
  if (const auto found = turns ? turning(now) : straight(now, goal)) m_last = found;
  m_before = now;
  return m_last;
}

std::optional<Motion> DragMotion::straight(const Pose& now, const DragGoal& goal) const {
  const Vec3 moved = now.translation - m_before.translation;
  Vec3 way = Vec3::Zero();
  if (goal.to && std::holds_alternative<PushOperation>(m_operation))
    way << goal.to->head<2>() - now.translation.head<2>(), 0;
  else if (goal.to)
    way = m_start.translation + *goal.to - now.translation;
  const double least = kLeastStep * m_size;
  if (way.norm() > least)
    return Motion::translation(way.normalized(), std::max(way.norm(), m_size));
  if (moved.norm() > least) return Motion::translation(moved.normalized(), m_size);
  return std::nullopt;
}

// The turn from the last pose to this one, and on.
std::optional<Motion> DragMotion::turning(const Pose& now) const {
  const Rotation& from = m_before.rotation;
  const Rotation turn = now.rotation * Rotation{from.w, -from.x, -from.y, -from.z};
  const Vec3 sine = (turn.w < 0 ? -1 : 1) * Vec3(turn.x, turn.y, turn.z);
  const double s = sine.norm() / std::abs(turn.w);
  if (!(s > kLeastTurn && s < kInfinity)) return std::nullopt;
  const Vec3 axis = sine.normalized();
  const Vec3 way = now.translation - m_before.translation;
  const Vec3 across = way - axis.dot(way) * axis;
  const Vec3 middle = 0.5 * (now.translation + m_before.translation);
  return Motion::rotation(middle + axis.cross(across) / (2 * s), axis, 1);
}

}  // namespace trivet::edit
