#include "gpu/live/camera.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/error.h"

namespace trivet {

ViewAxes make_view_axes(const LiveCamera& camera, double aspect) {
  // The picture's camera, in a frame equal to the world.
  const FrameCamera frame = make_frame_camera(camera, aspect, PictureFrame{});
  ViewAxes view{frame.forward, frame.right, frame.up};
  if (!camera.height) return view;
  if (!(std::isfinite(*camera.height) && *camera.height > 0))
    throw Error(Error::Kind::BadInput, "the camera shows %1 metres; accepted: more than 0",
                std::to_string(*camera.height));
  view.up *= 0.5 * *camera.height / view.up.norm();
  view.right *= 0.5 * *camera.height * aspect / view.right.norm();
  return view;
}

Eigen::Matrix4d clip_from_world(const LiveCamera& camera, const ViewAxes& view, double near_depth,
                                double far_depth) {
  const double span = far_depth - near_depth;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip.block<1, 3>(0, 0) = view.right.transpose() / view.right.squaredNorm();
  clip.block<1, 3>(1, 0) = view.up.transpose() / view.up.squaredNorm();
  if (camera.height) {
    clip.block<1, 3>(2, 0) = 2 / span * view.forward.transpose();
    clip.col(3) = -clip.leftCols<3>() * camera.eye;
    clip(2, 3) -= (far_depth + near_depth) / span;
    clip(3, 3) = 1;
  } else {
    clip.block<1, 3>(2, 0) = (far_depth + near_depth) / span * view.forward.transpose();
    clip.block<1, 3>(3, 0) = view.forward.transpose();
    clip.col(3) = -clip.leftCols<3>() * camera.eye;
    clip(2, 3) -= 2 * far_depth * near_depth / span;
  }
  return clip;
}

bool out_of_sight(const std::array<Vec3, 8>& corners, const Eigen::Matrix4d& clip_from_world) {
  int outside[5] = {};
  for (const Vec3& corner : corners) {
    const Eigen::Vector4d p = clip_from_world * corner.homogeneous();
    outside[0] += p.x() < -p.w();
    outside[1] += p.x() > p.w();
    outside[2] += p.y() < -p.w();
    outside[3] += p.y() > p.w();
    outside[4] += p.w() <= 0;
  }
  for (const int count : outside)
    if (count == 8) return true;
  return false;
}

}  // namespace trivet
