#include "apps/edit/tools/turning.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace trivet::edit {
namespace {

constexpr double kFromSide = 0.35;  // cosine between axis and view below which dragging is across
constexpr double kDegPerPx = 0.5;
constexpr double kDegPerRadian = 180 / std::numbers::pi;
constexpr double kRounding_deg = 0.01;

}  // namespace

Turning::Turning(const PointerEvent& pressed, const Vec3& centre, const Vec3& axis)
    : m_pressed_px(pressed.px) {
  const View& view = pressed.view;
  const View::Axes axes = view.axes();
  m_centre_px = view.project(centre).value_or(pressed.px);
  const Vec3 towards = view.orthographic ? axes.back : Vec3((view.eye - centre).normalized());
  const double along = axis.dot(towards);
  m_from_side = std::abs(along) < kFromSide;
  m_sign = along < 0 ? -1 : 1;
  // The side that faces the viewer moves along axis x towards.
  const Vec3 way = axis.cross(towards);
  const Vec2 across(way.dot(axes.right), -way.dot(axes.up));
  if (across.norm() > 0) m_across = across.normalized();
  m_last = angle_at(pressed);
}

double Turning::angle_at(const PointerEvent& event) const {
  if (m_from_side) return kDegPerPx * (event.px - m_pressed_px).dot(m_across);
  const Vec2 arm = event.px - m_centre_px;
  return m_sign * kDegPerRadian * std::atan2(-arm.y(), arm.x());
}

double Turning::follow(const PointerEvent& now, double step_deg) {
  const double angle = angle_at(now);
  double by = angle - m_last;
  if (!m_from_side) by = std::remainder(by, 360.0);
  m_last = angle;
  m_total += by;
  const double step = step_deg > 0 ? step_deg : kRounding_deg;
  return std::round(m_total / step) * step;
}

}  // namespace trivet::edit
