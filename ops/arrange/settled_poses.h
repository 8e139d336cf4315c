// Stable poses, snapped: where PUT lets an object rest that begins in them.
#pragma once

#include <memory>

#include "ops/arrange/stable_poses.h"

namespace trivet {

/// Degrees that a pose may turn by when it is put down, and still counts as that pose.
inline constexpr double kStaysDeg = 5;

struct SettledPose {
  Rotation rotation;      // at rest
  double turned_deg = 0;  // between its up then and that of the pose; 180: PUT did not end at rest
  bool stays() const { return turned_deg <= kStaysDeg; }
};

/// The pose let fall onto a floor, alone, with the default friction. Facets within 0.5 degrees are
/// one pose: models are never flat, and lie on three points of it.
SettledPose settled_pose(const std::shared_ptr<const Shape>& shape, UpAxis up, double scale,
                         const StablePose& pose);

}  // namespace trivet
