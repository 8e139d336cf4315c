// Private to gpu: the camera of a live view as matrices.
#pragma once

#include "core/picture/frame.h"
#include "gpu/live/scene.h"

namespace trivet {

/// Unit forward; right and up as long as half the picture is wide and high: at a distance of 1 for
/// a perspective eye, at any distance for an orthographic one. World axes.
struct ViewAxes {
  Vec3 forward, right, up;
};

/// @throws Error (BadInput) if the camera is not finite, has no direction or too wide an angle.
ViewAxes make_view_axes(const LiveCamera& camera, double aspect);

/// Clip coordinates from the world, in double. Depths between near and far are -1 to 1.
Eigen::Matrix4d clip_from_world(const LiveCamera& camera, const ViewAxes& view, double near_depth,
                                double far_depth);

/// Depth of a point in view.
inline double depth_of(const Vec3& p, const LiveCamera& camera, const ViewAxes& view) {
  return (p - camera.eye).dot(view.forward);
}

/// True if the convex hull of these corners is wholly beside, above or below the picture.
bool out_of_sight(const std::array<Vec3, 8>& corners, const Eigen::Matrix4d& clip_from_world);

}  // namespace trivet
