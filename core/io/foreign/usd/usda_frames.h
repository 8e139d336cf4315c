// Transforms of prims, and how their numbers change with a pose.
#pragma once

#include <string>
#include <vector>

#include "core/io/foreign/usd/usda_stage.h"
#include "core/motion/pose.h"

namespace trivet {

/// A transform: first `linear`, then the pose. It is the identity where nothing scales.
struct UsdaFrame {
  Pose pose;
  Mat3 linear = Mat3::Identity();

  Vec3 apply(const Vec3& p) const;
};
/// First b, then a. Poses stay exact where nothing scales, or all axes alike.
UsdaFrame composed(const UsdaFrame& a, const UsdaFrame& b);
/// Positive scale of all axes; nothing: axes differ, or are mirrored.
std::optional<double> uniform_scale(const Mat3& linear);

/// An operation as the prim's order has it.
struct UsdaOp {
  std::string name;  // "xformOp:translate", "!invert!xformOp:translate:pivot"
  std::string type;  // "double3"
  UsdaFrame frame;
};

struct UsdaOps {
  std::vector<UsdaOp> ops;  // the outermost first
  bool resets = false;      // what is above does not move the prim

  UsdaFrame local() const;
};
/// @param unread  gets operations that are not read, and poses over time.
UsdaOps usda_ops(const UsdaPrim& prim, std::vector<Sentence>& unread);

/// The place of the pose of a body: its numbers come from an over on that prim.
struct UsdaPlace {
  std::string path;
  UsdaFrame parent;  // world; metres
  UsdaOps ops;
  Pose in_body;  // of the prim in its body: bodies that fixed joints connect are one
};

/// Lines of an over that gives the prim a new pose in the world. @param old  its pose by the file.
std::vector<std::string> usda_pose_lines(const UsdaPlace& place, const Pose& old, const Pose& pose);

}  // namespace trivet
