// Joints of an opened scene, moved with what lies in and on their links.
#pragma once

#include "core/scene/joint.h"
#include "ops/files/foreign/open_scene.h"

namespace trivet {

/// @throws Error (BadInput) naming the joints that there are.
SceneJoint& joint_named(OpenedScene& opened, const std::string& name);

/// @throws Error (BadInput): the joint has no such limit.
double limit_of(const JointToMove& joint, bool upper);

/// A scene with the objects of `judged`, by the rules for moving links: they meet all but what they
/// hang in. The opened scene must have joints.
Scene with_moving_links(const JudgedScene& judged, Scene scene);

/// Why a joint that is held cannot be moved.
Sentence held_joint(const SceneJoint& joint);

/// Moves a joint as move_joint() does. Links that joints hold meet each other and all else, but for
/// what they hang in. The scene, its joints and `poses` follow.
/// @throws Error (BadInput): the joint is held.
JointMove move_joint_of(OpenedScene& opened, SceneJoint& joint, double to, const OperationRun& run,
                        NewPoses& poses);

/// Joints that would move once what lies in or on their links weighs, too. Joints are held where
/// they are; this tells where that takes a force.
/// @param scene  with the contacts of its poses.
std::vector<Sentence> joints_moved_by_contents(const Scene& scene,
                                               const std::vector<SceneJoint>& joints);

}  // namespace trivet
