// Conversion of mouse motion to a turn about an axis.
#pragma once

#include "apps/edit/tools/events.h"

namespace trivet::edit {

/// Follows the mouse about an axis through `centre`: seen along the axis, around its centre; seen
/// from the side, across it. Angles continue beyond half a turn.
class Turning {
 public:
  Turning() = default;
  Turning(const PointerEvent& pressed, const Vec3& centre, const Vec3& axis);
  /// Degrees from the pressed position, right-handed about the axis.
  /// @param step_deg  rounds to its multiples; 0: to a hundredth of a degree.
  double follow(const PointerEvent& now, double step_deg);

 private:
  double angle_at(const PointerEvent& event) const;

  Vec2 m_pressed_px = Vec2::Zero(), m_centre_px = Vec2::Zero();
  Vec2 m_across = Vec2::UnitX();  // seen from the side: direction of a positive turn, pixels
  bool m_from_side = false;
  double m_sign = 1, m_last = 0, m_total = 0;
};

}  // namespace trivet::edit
