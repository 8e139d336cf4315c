// Exact comparison of poses. Private.
#pragma once

#include "core/motion/pose.h"

namespace trivet::edit {

/// Bitwise equality.
inline bool same_pose(const Pose& a, const Pose& b) {
  return a.translation == b.translation && a.rotation.w == b.rotation.w &&
         a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y &&
         a.rotation.z == b.rotation.z;
}

}  // namespace trivet::edit
