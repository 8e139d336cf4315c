// Joints of URDF and SDF: links as the files have them at zero, moved to the values of their
// joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/foreign/joint_values.h"
#include "core/io/foreign/scene.h"

namespace trivet {

/// A joint that is the other's value times `multiplier`, plus `offset`: metres or radians.
struct MimicRule {
  std::string joint;
  double multiplier = 1, offset = 0;
};

/// A joint as its file has it, with everything at zero, or where it stands.
struct TreeJoint {
  std::string name;
  std::optional<ForeignJoint::Kind> kind;            // nothing: of a kind that stays where it is
  size_t child = 0;                                  // a body of the scene
  std::optional<size_t> parent;                      // nothing: the world
  Vec3 axis = Vec3::UnitX(), anchor = Vec3::Zero();  // world
  double lower = -kInfinity, upper = kInfinity;      // metres or radians
  double value = 0;                                  // where no file of values says another
  double stands_at = 0;                              // value at which the file has its bodies
  double friction = 0;                               // that holds it: newtons or newton metres
  std::optional<MimicRule> mimic;
  bool driven = false;  // something else holds it
};

/// Moves the bodies to the values, and adds the slides and hinges to the scene. Joints that mimic,
/// are mimicked, or close a chain are told as held. Bodies that hang in a joint get its parent as
/// theirs.
/// @throws Error (BadInput): values of joints that are not there or that mimic others.
void add_tree_joints(std::vector<TreeJoint> joints, const JointValues& values, ForeignScene& scene);

}  // namespace trivet
