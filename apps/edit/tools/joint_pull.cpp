#include "apps/edit/tools/joint_pull.h"

#include <algorithm>
#include <cmath>

#include "apps/edit/tools/placing.h"
#include "apps/edit/tools/snapping.h"
#include "core/scene/joint.h"

namespace trivet::edit {
namespace {

constexpr double kAlongView = 0.95;  // cosine: an axis seen flatter has no length in the view

}  // namespace

JointPull::JointPull(const PointerEvent& pressed, const Object& link, const Vec3& grabbed)
    : m_name(link.name),
      m_joint(joint_place(*link.joint, link.pose)),
      m_pressed(pressed),
      m_grabbed(grabbed),
      m_centre(m_joint.anchor + m_joint.axis.dot(grabbed - m_joint.anchor) * m_joint.axis) {
  if (turns()) m_turning = Turning(pressed, m_centre, m_joint.axis);
}

MoveJointOperation JointPull::operation() const {
  MoveJointOperation operation;
  operation.object = m_name;
  operation.to = m_joint.value;
  return operation;
}

double JointPull::value_at(const PointerEvent& event, double step) {
  const double way = turns() ? m_turning.follow(event, 0) : slid(event);
  const double value = on_grid(m_joint.value + way, step);
  return std::clamp(value, m_joint.lower, m_joint.upper);
}

// Metres along the axis, rounded to less than a pixel.
double JointPull::slid(const PointerEvent& event) const {
  const View& view = m_pressed.view;
  const double metres = view.metres_per_px(view.depth(m_grabbed));
  const double towards = -m_joint.axis.dot(view.forward());
  double way = metres * (event.px.y() - m_pressed.px.y()) * (towards < 0 ? -1 : 1);
  if (std::abs(towards) < kAlongView) {
    const auto a = on_line(m_pressed.ray(), m_grabbed, m_joint.axis);
    const auto b = on_line(event.ray(), m_grabbed, m_joint.axis);
    if (a && b) way = (*b - *a).dot(m_joint.axis);
  }
  return rounded(way, metres / kGoalsPerPx);
}

std::array<Vec3, 2> JointPull::line(double arm) const {
  const Vec3& axis = m_joint.axis;
  if (turns()) return {m_centre - arm * axis, m_centre + arm * axis};
  const auto end = [&](double limit, double without) {
    const double way = std::isfinite(limit) ? limit - m_joint.value : without;
    return Vec3(m_grabbed + way * axis);
  };
  return {end(m_joint.lower, -arm), end(m_joint.upper, arm)};
}

}  // namespace trivet::edit
