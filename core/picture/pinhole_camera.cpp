#include "core/picture/pinhole_camera.h"

#include <Eigen/LU>
#include <string>

#include "core/base/bad_input.h"
#include "core/picture/frame.h"

namespace trivet {

PinholeCamera pinhole_camera(const Camera& camera, int width, int height) {
  const CameraAxes axes = camera_axes(camera);
  PinholeCamera out;
  out.width = width, out.height = height;
  out.fx = out.fy = 0.5 * height / axes.tan_half_fov;
  out.cx = 0.5 * (width - 1), out.cy = 0.5 * (height - 1);
  out.camera_from_world.row(0) = axes.world_from_view.col(0);
  out.camera_from_world.row(1) = -axes.world_from_view.col(1);
  out.camera_from_world.row(2) = -axes.world_from_view.col(2);
  out.eye = camera.eye;
  return out;
}

void check_camera(const PinholeCamera& camera) {
  const auto side_is_good = [](int side) { return side >= 1 && side <= kMaxPictureSide; };
  if (!side_is_good(camera.width) || !side_is_good(camera.height))
    bad_input("a picture of %1 x %2 pixels; accepted: 1 to %3 in each dimension", camera.width,
              camera.height, kMaxPictureSide);
  if (!(camera.fx > 0 && camera.fx < 1e9 && camera.fy > 0 && camera.fy < 1e9))
    bad_input("the camera has focal lengths of %1 and %2 pixels; accepted: above 0, below 1e9",
              std::to_string(camera.fx), std::to_string(camera.fy));
  if (!(std::abs(camera.cx) < 1e9 && std::abs(camera.cy) < 1e9))
    bad_input("the camera's principal point is %1, %2; accepted: -1e9 to 1e9 pixels",
              std::to_string(camera.cx), std::to_string(camera.cy));
  if (!camera.eye.allFinite()) bad_input("the camera is not finite");
  const Mat3& r = camera.camera_from_world;
  const bool is_rotation = r.allFinite() &&
                           (r * r.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-6 &&
                           r.determinant() > 0;
  if (!is_rotation)
    bad_input(
        "the camera's orientation is no rotation; accepted: an orthonormal, right-handed "
        "matrix to 1e-6");
}

}  // namespace trivet
