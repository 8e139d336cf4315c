// Values of joints for formats that have no place for them: a file beside the scene, named as it
// with ".joints.json" added. {"door": 1.2, "drawer": 0.3}: radians, metres.
#pragma once

#include <map>
#include <string>

namespace trivet {

using JointValues = std::map<std::string, double>;  // by the name of the joint

std::string joint_values_path(const std::string& scene);

/// Empty if there is no such file.
/// @throws Error (BadInput): no regular file, too long, no object of numbers up to 1e6.
JointValues read_joint_values(const std::string& path);

/// A joint a line.
std::string joint_values_text(const JointValues& values);

}  // namespace trivet
