// Joints of a model of SDF. Private to its reader.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/io/foreign/joint_tree.h"

namespace trivet {

/// The links of a model and the bodies that they are parts of.
struct SdfLinks {
  const std::string& model;
  const Pose& world;                                // of the model
  bool model_axes = false;                          // axes are in its frame, as old versions say
  const std::map<std::string, std::string>& group;  // by link
  const std::map<std::string, size_t>& body_of;     // by group
  std::function<Pose(const XmlNode& asking, const std::string& frame)> pose_of;  // world
  std::function<Pose(const XmlNode& joint)> pose_of_joint;                       // the same
};

/// Adds the joints that are not fixed. Notes name those that stay where they are.
void add_sdf_joints(const XmlNode& model, const SdfLinks& links, ForeignScene& scene,
                    std::vector<TreeJoint>& joints);

}  // namespace trivet
