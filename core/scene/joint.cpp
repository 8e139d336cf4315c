#include "core/scene/joint.h"

#include <cmath>

#include "core/motion/compose.h"
#include "core/motion/motion.h"

namespace trivet {
namespace {

Pose unit(const Pose& pose) { return {pose.rotation.normalized(), pose.translation}; }

// The pose that the link would have at zero.
Pose pose_at_zero(const LinkJoint& joint, const Pose& parent) {
  // A parent that never moved gives the very pose that was given.
  if (is_same_pose(parent, joint.parent_then)) return joint.at_zero;
  return unit(composed(parent, composed(inverse(joint.parent_then), joint.at_zero)));
}

// By a value along or about the joint, from a pose of the link.
Pose displaced(const LinkJoint& joint, const Pose& link, double by) {
  if (by == 0) return link;
  const Vec3 axis = world_axis(joint, link);
  if (!joint.turns()) return {link.rotation, link.translation + by * axis};
  const Vec3 anchor = world_anchor(joint, link);
  const Rotation turn = turn_about(axis, by);
  return {(turn * link.rotation).normalized(),
          anchor + turn.matrix() * (link.translation - anchor)};
}

// Degrees from -180 to 180 of a turn about a unit axis.
double degrees_about(const Rotation& turn, const Vec3& axis) {
  const double along = axis.dot(Vec3(turn.x, turn.y, turn.z));
  const double sign = (along < 0) != (turn.w < 0) ? -1 : 1;
  const double sine = std::abs(along), cosine = std::abs(turn.w);
  if (sine <= cosine) return cosine == 0 ? 0 : sign * turned_deg(sine / cosine);
  return sign * (180 - turned_deg(cosine / sine));
}

}  // namespace

Vec3 world_axis(const LinkJoint& joint, const Pose& link) {
  return (link.rotation.matrix() * joint.axis).normalized();
}

Vec3 world_anchor(const LinkJoint& joint, const Pose& link) {
  return link.translation + link.rotation.matrix() * joint.anchor;
}

Pose link_pose(const LinkJoint& joint, const Pose& parent, double value) {
  return displaced(joint, pose_at_zero(joint, parent), value);
}

double joint_value(const LinkJoint& joint, const Pose& parent, const Pose& link) {
  const Pose zero = pose_at_zero(joint, parent);
  const Vec3 axis = world_axis(joint, zero);
  if (!joint.turns()) return axis.dot(link.translation - zero.translation);
  const Rotation& r = zero.rotation;
  const double angle = degrees_about(link.rotation * Rotation{r.w, -r.x, -r.y, -r.z}, axis);
  return angle + 360 * std::round((joint.value - angle) / 360);
}

LinkJoint hung(LinkJoint joint, const Pose& parent, const Pose& link) {
  joint.parent_then = parent;
  joint.at_zero = displaced(joint, link, -joint.value);
  return joint;
}

JointPlace joint_place(const LinkJoint& joint, const Pose& link) {
  return {
      joint.turns(), world_axis(joint, link), world_anchor(joint, link), joint.value, joint.lower,
      joint.upper};
}

std::vector<ObjectId> links_below(const Scene& scene, ObjectId id) {
  std::vector<ObjectId> out = scene.at(id).links;
  // Links of links join while the list is walked.
  for (size_t i = 0; i < out.size(); ++i)
    for (const ObjectId below : scene.at(out[i]).links) out.push_back(below);
  return out;
}

std::vector<ObjectId> one_body(const Scene& scene, ObjectId id) {
  std::vector<ObjectId> out = {id};
  for (const ObjectId link : links_below(scene, id))
    if (scene.at(link).placed) out.push_back(link);
  return out;
}

ObjectId root_of(const Scene& scene, ObjectId id) {
  while (const auto& joint = scene.at(id).joint) id = joint->parent;
  return id;
}

}  // namespace trivet
