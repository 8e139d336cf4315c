// The picture frame and the camera in it.
//
// The picture frame is the world moved and scaled so that the box of all objects is centred on the
// origin and has a diagonal of 1. All renderers use it, in float32, so that biases and fade-outs
// are the same for a scene of a millimetre and of a kilometre.
#pragma once

#include "core/picture/pinhole_camera.h"
#include "core/picture/scene.h"

namespace trivet {

/// frame = (world - centre) * scale.
struct PictureFrame {
  Vec3 centre = Vec3::Zero();
  double scale = 1;
  Aabb world_box;       // of all finite vertices; a unit cube if there are none
  double floor_z = 0;   // frame
  double radius = 0.5;  // horizontal, of the box, frame

  Vec3 apply(const Vec3& world) const { return (world - centre) * scale; }
};

PictureFrame make_picture_frame(const PictureScene& scene);
/// Frame of a scene with that box; of a unit cube if it is empty.
PictureFrame frame_of_box(const Aabb& world_box);

/// Orientation of a camera, world frame.
struct CameraAxes {
  Mat3 world_from_view;  // columns: right, up and backward, unit vectors
  double tan_half_fov;   // of the vertical field of view
};

/// @throws Error (BadInput) if the camera is not finite, has no direction or too wide an angle.
CameraAxes camera_axes(const Camera& camera);

/// Without the mathematical library, whose last bits differ between machines.
/// @param deg  0 to 170.
double tan_of_half_deg(double deg);

/// A camera in the picture frame. A point p is at ndc (x, y) + middle where
/// p - eye is a multiple of forward + x * right + y * up.
struct FrameCamera {
  Vec3 eye, forward;           // forward is a unit vector
  Vec3 right, up;              // scaled by the tangents of half the field of view
  Vec2 middle = Vec2::Zero();  // where forward is seen
};

/// @throws Error (BadInput) as camera_axes().
FrameCamera make_frame_camera(const Camera& camera, double aspect, const PictureFrame& frame);
FrameCamera make_frame_camera(const PinholeCamera& camera, const PictureFrame& frame);

}  // namespace trivet
