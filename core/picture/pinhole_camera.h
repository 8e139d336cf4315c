// The camera of labelled images, in the convention of OpenCV.
#pragma once

#include "core/picture/scene.h"

namespace trivet {

/// Camera frame: x to the right, y down, z forward. Pixel (i, j) of column i and row j, from above
/// left, has its centre at image coordinates (i, j); a point (x, y, z) of the camera frame is at
/// (fx x / z + cx, fy y / z + cy). No distortion.
struct PinholeCamera {
  int width = 1280, height = 720;             // pixels, 1 to 16384
  double fx = 1, fy = 1;                      // focal lengths, pixels
  double cx = 0, cy = 0;                      // principal point, pixels
  Mat3 camera_from_world = Mat3::Identity();  // rotation
  Vec3 eye = Vec3::Zero();                    // world, metres

  /// Camera coordinates of a point of the world.
  Vec3 apply(const Vec3& world) const { return rotate(world - eye); }
  /// Camera coordinates of a direction.
  Vec3 rotate(const Vec3& world) const {
    Vec3 out;
    for (int r = 0; r < 3; ++r)
      out[r] = camera_from_world(r, 0) * world.x() + camera_from_world(r, 1) * world.y() +
               camera_from_world(r, 2) * world.z();
    return out;
  }
};

/// The same view: square pixels, the principal point in the middle.
/// @throws Error (BadInput) if the camera is not finite, has no direction or too wide an angle.
PinholeCamera pinhole_camera(const Camera& camera, int width, int height);

/// @throws Error (BadInput) naming what is out of range: sizes, focal lengths that are not above
///   zero, numbers that are not finite, a matrix that is no rotation to 1e-6.
void check_camera(const PinholeCamera& camera);

}  // namespace trivet
