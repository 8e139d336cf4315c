// Angles between directions, by the series of core/motion: no libm, the same bits everywhere.
#pragma once

#include "core/base/cross.h"
#include "core/base/types.h"
#include "core/motion/pose.h"

namespace trivet {

/// In [0, 180] degrees, with tan(angle / 2) = s / c; neither negative, not both zero.
double twice_arctangent_deg(double s, double c);

/// In [0, 180] degrees; of any lengths but zero.
double angle_between_deg(const Vec3& a, const Vec3& b);
double angle_between_deg(const Vec2& a, const Vec2& b);

/// About z, right-handed. @param angle_deg  any.
Rotation turned_about_z(double angle_deg);

/// The smallest rotation that takes unit `from` to unit `to`; of opposite ones about x or y.
Rotation smallest_rotation(const Vec3& from, const Vec3& to);

/// x and y axis of the plane turned by a quarter, counter-clockwise.
inline Vec2 quarter_turned(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace trivet
