#include "core/picture/frame.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace trivet {
namespace {

constexpr double kAutomaticFovDeg = 26;
constexpr double kAutomaticElevationDeg = 27;
constexpr double kAutomaticAzimuthDeg = -62;  // from +x towards +y: in front, slightly right
constexpr double kMargin = 0.10;  // fraction of the picture that stays free at each edge

const Aabb kUnitCube{Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1)};

double radians(double deg) { return deg * std::numbers::pi / 180; }

/// Calls visit(world position) for every finite vertex of the scene.
template <typename Visit>
void for_each_vertex(const PictureScene& scene, const Visit& visit) {
  for (const PictureObject& object : scene.objects)
    for (const Vec3& vertex : object.mesh->vertices)
      if (const Vec3 p = object.world_from_object.apply(vertex); p.allFinite()) visit(p);
}

Aabb world_box(const PictureScene& scene) {
  Aabb box;
  for_each_vertex(scene, [&](const Vec3& p) { box.extend(p); });
  return box.empty() ? kUnitCube : box;
}

/// Right, up and backward of a view, unit vectors in the columns.
Mat3 view_axes(const Vec3& backward, const Vec3& up_hint) {
  Vec3 up = up_hint;
  if (up.cross(backward).norm() <= 1e-9 * up.norm()) up = Vec3::UnitY();
  if (up.cross(backward).norm() <= 1e-9) up = Vec3::UnitX();
  Mat3 axes;
  axes.col(2) = backward;
  axes.col(0) = up.cross(backward).normalized();
  axes.col(1) = backward.cross(axes.col(0));
  return axes;
}

/// The four planes of the view pyramid, each moved out to the furthest point.
struct PyramidSupport {
  double right = -kInfinity, left = -kInfinity, top = -kInfinity, bottom = -kInfinity;

  void extend(const Vec3& p, double tan_x, double tan_y) {
    right = std::max(right, p.x() + tan_x * p.z());
    left = std::max(left, -p.x() + tan_x * p.z());
    top = std::max(top, p.y() + tan_y * p.z());
    bottom = std::max(bottom, -p.y() + tan_y * p.z());
  }
};

}  // namespace

PictureFrame make_picture_frame(const PictureScene& scene) {
  return frame_of_box(world_box(scene));
}

PictureFrame frame_of_box(const Aabb& world_box) {
  PictureFrame frame;
  frame.world_box = world_box.empty() ? kUnitCube : world_box;
  frame.centre = frame.world_box.centre();
  const double diagonal = frame.world_box.diagonal();
  // A single point, or a box whose inverse overflows float32: use a metre.
  frame.scale = diagonal > 1e-30 ? 1 / diagonal : 1;
  frame.floor_z = -frame.centre.z() * frame.scale;
  const Vec3 half = frame.world_box.half_extent() * frame.scale;
  frame.radius = std::hypot(half.x(), half.y());
  return frame;
}

Camera automatic_camera(const PictureScene& scene, double aspect) {
  const double azimuth = radians(kAutomaticAzimuthDeg), elevation = radians(kAutomaticElevationDeg);
  const Vec3 backward(std::cos(azimuth) * std::cos(elevation),
                      std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const Mat3 axes = view_axes(backward, Vec3::UnitZ());
  const Aabb box = world_box(scene);
  const Vec3 centre = box.centre();
  const double tan_y = std::tan(0.5 * radians(kAutomaticFovDeg)) * (1 - 2 * kMargin);
  const double tan_x = tan_y * aspect;
  PyramidSupport support;
  const auto extend = [&](const Vec3& p) {
    support.extend(axes.transpose() * (p - centre), tan_x, tan_y);
  };
  for_each_vertex(scene, extend);
  if (support.right == -kInfinity)
    for (int i = 0; i < 8; ++i)
      extend(centre +
             box.half_extent().cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  // Centred between opposite planes, and as far back as the wider pair requires.
  const double x = 0.5 * (support.right - support.left);
  const double y = 0.5 * (support.top - support.bottom);
  const double z = std::max(0.5 * (support.right + support.left) / tan_x,
                            0.5 * (support.top + support.bottom) / tan_y);
  const double size = box.diagonal() > 0 ? box.diagonal() : 1;
  Camera camera;
  camera.target = centre + axes * Vec3(x, y, 0);
  // A point or a line along the view has no extent to frame: stay one size away.
  camera.eye = centre + axes * Vec3(x, y, std::max(z, 0.6 * size));
  camera.fov_deg = kAutomaticFovDeg;
  return camera;
}

double tan_of_half_deg(double deg) {
  // Lambert's continued fraction: 24 steps leave only rounding up to 85 degrees.
  const double x = 0.5 * radians(deg);
  double below = 0;
  for (int k = 24; k >= 1; --k) below = x * x / (2 * k + 1 - below);
  return x / (1 - below);
}

CameraAxes camera_axes(const Camera& camera) {
  const auto bad = [](const Sentence& what) {
    return Error(Error::Kind::BadInput, "the camera %1", what);
  };
  if (!camera.eye.allFinite() || !camera.target.allFinite() || !camera.up.allFinite())
    throw bad("is not finite");
  if (!(camera.fov_deg >= 1 && camera.fov_deg <= 170))
    throw bad(say("has a field of view of %1 degrees; accepted: 1 to 170",
                  std::to_string(camera.fov_deg)));
  const Vec3 backward = camera.eye - camera.target;
  if (!(backward.norm() > 0))
    throw bad("has its eye at its target; accepted: two different points");
  return {view_axes(backward.normalized(), camera.up), tan_of_half_deg(camera.fov_deg)};
}

FrameCamera make_frame_camera(const Camera& camera, double aspect, const PictureFrame& frame) {
  const auto [axes, tan_y] = camera_axes(camera);
  FrameCamera out;
  out.eye = frame.apply(camera.eye);
  out.forward = -axes.col(2);
  out.right = axes.col(0) * (tan_y * aspect);
  out.up = axes.col(1) * tan_y;
  return out;
}

// The centres of pixels have whole coordinates, from above.
FrameCamera make_frame_camera(const PinholeCamera& camera, const PictureFrame& frame) {
  FrameCamera out;
  out.eye = frame.apply(camera.eye);
  out.right = camera.camera_from_world.row(0) * (0.5 * camera.width / camera.fx);
  out.up = -camera.camera_from_world.row(1) * (0.5 * camera.height / camera.fy);
  out.forward = camera.camera_from_world.row(2);
  out.middle = {(2 * camera.cx + 1) / camera.width - 1, 1 - (2 * camera.cy + 1) / camera.height};
  return out;
}

}  // namespace trivet
