#include "apps/edit/window/view_camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet::edit {
namespace {

constexpr double kTurnPerPx = 0.4 * std::numbers::pi / 180;
constexpr double kSteepest = 89.5 * std::numbers::pi / 180;  // of the view, over and under
constexpr double kZoomPerStep = 0.88;
constexpr double kNearest = 1e-3, kFarthest = 1e5;  // metres

}  // namespace

View ViewCamera::view(const QSize& size) const {
  View view;
  view.eye = m_camera.eye, view.target = m_camera.target, view.up = m_camera.up;
  view.fov_deg = m_camera.fov_deg;
  view.orthographic = is_orthographic();
  view.height = m_camera.height.value_or(1);
  view.width_px = std::max(size.width(), 1), view.height_px = std::max(size.height(), 1);
  return view;
}

ViewCamera ViewCamera::of(const View& view) {
  ViewCamera out;
  LiveCamera& camera = out.m_camera;
  camera.eye = view.eye, camera.target = view.target, camera.up = view.up;
  camera.fov_deg = view.fov_deg;
  if (view.orthographic) camera.height = view.height;
  return out;
}

ViewCamera ViewCamera::perspective() {
  ViewCamera out;
  out.m_camera.eye = Vec3(1.6, -2.6, 1.7);
  out.m_camera.target = Vec3(0, 0, 0.2);
  return out;
}

ViewCamera ViewCamera::orthographic(const Vec3& direction, const Vec3& up) {
  ViewCamera out;
  out.m_camera.height = 2;
  out.m_camera.target = Vec3(0, 0, 0.4);
  out.look_along(direction, up);
  return out;
}

void ViewCamera::orbit(const QPointF& moved_px) {
  const Vec3 back = m_camera.eye - m_camera.target;
  const double distance = back.norm();
  const double azimuth = std::atan2(back.y(), back.x()) - kTurnPerPx * moved_px.x();
  double elevation = std::asin(std::clamp(back.z() / distance, -1.0, 1.0));
  elevation = std::clamp(elevation + kTurnPerPx * moved_px.y(), -kSteepest, kSteepest);
  m_camera.up = Vec3::UnitZ();
  m_camera.eye = m_camera.target + distance * Vec3(std::cos(azimuth) * std::cos(elevation),
                                                   std::sin(azimuth) * std::cos(elevation),
                                                   std::sin(elevation));
}

void ViewCamera::pan(const QPointF& moved_px, const QSize& size) {
  const View now = view(size);
  const View::Axes axes = now.axes();
  const double metres = now.metres_per_px(now.depth(m_camera.target));
  const Vec3 by = metres * (-moved_px.x() * axes.right + moved_px.y() * axes.up);
  m_camera.eye += by, m_camera.target += by;
}

void ViewCamera::zoom(double steps, const QPointF& at, const QSize& size) {
  const double shown =
      is_orthographic() ? *m_camera.height : (m_camera.eye - m_camera.target).norm();
  const double factor =
      std::clamp(shown * std::pow(kZoomPerStep, steps), kNearest, kFarthest) / shown;
  const QPointF off(at.x() - 0.5 * size.width(), at.y() - 0.5 * size.height());
  pan(-off * (1 - factor), size);
  if (is_orthographic())
    *m_camera.height *= factor;
  else
    m_camera.eye = m_camera.target + factor * (m_camera.eye - m_camera.target);
}

void ViewCamera::frame(const Aabb& box, const QSize& size) {
  m_camera = framed(m_camera, box, double(std::max(size.width(), 1)) / std::max(size.height(), 1));
}

void ViewCamera::look_along(const Vec3& direction, const Vec3& up) {
  const double distance = std::max((m_camera.eye - m_camera.target).norm(), 1.0);
  m_camera.eye = m_camera.target - distance * direction.normalized();
  m_camera.up = up;
}

void ViewCamera::look_at(const Vec3& target) {
  m_camera.eye += target - m_camera.target;
  m_camera.target = target;
}

}  // namespace trivet::edit
