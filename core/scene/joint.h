// Joints between objects: a link slides or turns in what it hangs in, and is fixed otherwise.
#pragma once

#include <limits>
#include <optional>

#include "core/scene/joint_load.h"
#include "core/scene/scene.h"

namespace trivet {

inline constexpr double kMaxJointValue = 1e6;  // metres or degrees

/// A joint of one degree of freedom. Where its link is follows from where the parent is and from
/// the value alone, to the bit, whatever led there.
struct LinkJoint {
  enum class Kind { Slide, Hinge } kind = Kind::Slide;
  ObjectId parent;  // that it hangs in
  // In the link's own frame, z up, metres, from its origin; a turn is right-handed about the axis.
  Vec3 axis = Vec3::UnitZ();                     // unit
  Vec3 anchor = Vec3::Zero();                    // a point on the axis of a hinge
  double lower = -kInfinity, upper = kInfinity;  // metres or degrees
  double value = 0;
  std::optional<double> friction;  // that holds it, newtons or newton metres; nothing: locked
  Pose parent_then, at_zero;       // of parent and link once, if the value were 0 then

  bool turns() const { return kind == Kind::Hinge; }
};

/// Pose of the link at a value. @param parent  pose of what it hangs in, now.
Pose link_pose(const LinkJoint& joint, const Pose& parent, double value);
/// Value at which the link has this pose, or comes nearest; of a hinge the one nearest to
/// joint.value.
double joint_value(const LinkJoint& joint, const Pose& parent, const Pose& link);
/// The joint of a link that has this pose at joint.value.
LinkJoint hung(LinkJoint joint, const Pose& parent, const Pose& link);

/// Axis and anchor of a link's joint, in the world.
Vec3 world_axis(const LinkJoint& joint, const Pose& link);
Vec3 world_anchor(const LinkJoint& joint, const Pose& link);

/// The joint of a link in the world.
JointPlace joint_place(const LinkJoint& joint, const Pose& link);

/// All that hang in an object by joints, those above first.
std::vector<ObjectId> links_below(const Scene& scene, ObjectId id);
/// The object, and all that hang in it: one rigid body while joints are held.
std::vector<ObjectId> one_body(const Scene& scene, ObjectId id);
/// The object that a link hangs in, directly or by others, and that hangs in none; of all others:
/// itself.
ObjectId root_of(const Scene& scene, ObjectId id);

}  // namespace trivet
