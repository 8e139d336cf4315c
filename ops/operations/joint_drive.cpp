#include "ops/operations/joint_drive.h"

#include <algorithm>
#include <cmath>

#include "core/scene/friction.h"
#include "core/scene/transaction.h"
#include "ops/operations/moving_group.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kMostTurnOfPartDeg = 90;

class JointDrive {
 public:
  JointDrive(Scene& scene, const JointToMove& joint, const OperationRun& run)
      : m_scene(scene), m_joint(joint), m_run(run) {
    // Bodies of the joint move with their loads; those are told, as nobody named them.
    m_clearance.distance = clearance_near(scene, run.options, scene.box());
    m_ids = carried_with(scene, joint.links[0], std::span(joint.links).subspan(1));
    for (const ObjectId id : m_ids) m_poses.push_back(scene.at(id).pose);
    m_out.value = joint.value;
    for (const ObjectId id : m_ids)
      if (std::find(joint.links.begin(), joint.links.end(), id) == joint.links.end())
        m_out.carried.push_back(id);
  }

  JointMove move(double to) {
    // The joint's own limits come before any obstacle.
    const double goal = std::clamp(to, m_joint.lower, m_joint.upper);
    // A turn goes in quarters, as motions do, until the goal or an obstacle is reached.
    while (m_out.end != JointMove::End::Blocked && m_out.value != goal) advance(goal);
    if (m_out.value == goal && goal != to) m_out.end = JointMove::End::Limit;
    for (size_t i = 0; i < m_ids.size(); ++i)
      edit_object(m_scene, m_ids[i], [&](Object& o) { o.pose = m_poses[i]; });
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
    for (Pose& pose : m_poses) pose = moved_pose(pose, motion, time);
    // A whole part ends exactly at its goal, without the rounding of tangents.
    if (m_out.end != JointMove::End::Blocked)
      m_out.value = part == std::abs(way) ? goal : m_out.value + sign * part;
    else
      m_out.value += sign * (m_joint.turns ? turned_deg(time) : time);
  }

  // The first contact of any of them with what stays.
  double free_time(const Motion& motion) {
    double time = motion.limit;
    // Members have different bodies that they may pass through, so that each asks for itself.
    for (size_t i = 0; i < m_ids.size(); ++i) {
      const Body body = body_of(m_scene.at(m_ids[i]), m_poses[i]);
      Neighbourhood others(m_scene, m_ids);
      others.leave_out(passed_by(m_scene.at(m_ids[i])));
      const ObstacleContact found =
          first_contact({&body, 1}, others, motion, m_clearance, m_run.detector);
      if (found.status == FirstContact::Status::Free) continue;
      const double at = found.status == FirstContact::Status::Crossing ? 0 : found.time;
      // The earliest contact of all members counts.
      if (m_out.end == JointMove::End::Blocked && at >= time) continue;
      time = std::min(at, motion.limit);
      m_out.end = JointMove::End::Blocked;
      m_out.blocker = found.with;
      m_out.point = found.point;
    }
    return time;
  }

  // A rule for one of the group does not hold for the others.
  std::vector<Support> passed_by(const Object& object) const {
    std::vector<Support> out;
    if (may_pass_floor(m_scene, object)) out.push_back(Support::floor());
    for (const ObjectId id : m_scene.ids())
      if (may_pass(m_scene, object, m_scene.at(id))) out.push_back(id);
    return out;
  }

  Scene& m_scene;
  const JointToMove& m_joint;
  const OperationRun& m_run;
  Clearance m_clearance;
  std::vector<ObjectId> m_ids;
  std::vector<Pose> m_poses;
  JointMove m_out;
};

}  // namespace

JointMove move_joint(Scene& scene, const JointToMove& joint, double to, const OperationRun& run) {
  return JointDrive(scene, joint, run).move(to);
}

}  // namespace trivet
