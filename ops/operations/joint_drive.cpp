#include "ops/operations/joint_drive.h"

#include <algorithm>
#include <cmath>

#include "core/scene/transaction.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kMostTurnOfPartDeg = 90;

class JointDrive {
 public:
  JointDrive(MovingGroup& group, const JointToMove& joint) : m_group(group), m_joint(joint) {
    m_out.value = joint.value;
    // Bodies of the joint move with their loads; those are told, as nobody named them.
    for (const ObjectId id : group.ids())
      if (std::find(joint.links.begin(), joint.links.end(), id) == joint.links.end())
        m_out.carried.push_back(id);
  }

  JointMove move(double to, const std::function<void()>& stepped) {
    // The joint's own limits come before any obstacle.
    const double goal = std::clamp(to, m_joint.lower, m_joint.upper);
    // A turn goes in quarters, as motions do, until the goal or an obstacle is reached.
    while (m_out.end != JointMove::End::Blocked && m_out.value != goal) {
      advance(goal);
      if (stepped) stepped();
    }
    if (m_out.value == goal && goal != to) m_out.end = JointMove::End::Limit;
    return m_out;
  }

 private:
  // One motion: the whole slide, or at most a quarter turn.
  void advance(double goal) {
    const double way = goal - m_out.value, sign = way < 0 ? -1 : 1;
    const double part = m_joint.turns ? std::min(std::abs(way), kMostTurnOfPartDeg) : std::abs(way);
    const Motion motion =
        m_joint.turns ? Motion::rotation(m_joint.anchor, sign * m_joint.axis, turn_time(part))
                      : Motion::translation(sign * m_joint.axis, part);
    const double time = free_time(motion);
    m_group.advance(motion, time);
    // A whole part ends exactly at its goal, without the rounding of tangents.
    if (m_out.end != JointMove::End::Blocked)
      m_out.value = part == std::abs(way) ? goal : m_out.value + sign * part;
    else
      m_out.value += sign * (m_joint.turns ? turned_deg(time) : time);
  }

  // Until the first contact of any of them with what stays.
  double free_time(const Motion& motion) {
    const ObstacleContact found = m_group.first_contact(motion);
    if (found.status == FirstContact::Status::Free) return motion.limit;
    m_out.end = JointMove::End::Blocked;
    m_out.blocker = found.with;
    m_out.point = found.point;
    return found.status == FirstContact::Status::Crossing ? 0 : std::min(found.time, motion.limit);
  }

  MovingGroup& m_group;
  const JointToMove& m_joint;
  JointMove m_out;
};

}  // namespace

JointMove drive_joint(MovingGroup& group, const JointToMove& joint, double to,
                      const std::function<void()>& stepped) {
  return JointDrive(group, joint).move(to, stepped);
}

JointMove move_joint(Scene& scene, const JointToMove& joint, double to, const OperationRun& run) {
  MovingGroup group(scene, joint.links[0], std::span(joint.links).subspan(1),
                    clearance_near(scene, run.options, scene.box()), run.options, run.detector);
  JointMove out = drive_joint(group, joint, to);
  const std::vector<Placement> ends = group.placements();
  for (const Placement& end : ends)
    edit_object(scene, end.id, [&](Object& o) { o.pose = end.pose; });
  return out;
}

}  // namespace trivet
