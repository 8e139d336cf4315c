// Signs of determinants, exactly: a floating-point filter with a proved error bound, then exact
// expansion arithmetic [Shewchuk 1997]. Valid unless products overflow or underflow; inputs between
// 1e-70 and 1e70 in magnitude, or zero, are safe.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// Sign of (b - a) x (c - a): +1 counter-clockwise, -1 clockwise, 0 collinear.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of det(a - d, b - d, c - d): +1 if d lies below the plane through a, b, c (they look
/// counter-clockwise from above), -1 above, 0 in the plane.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// True if the three points are on one line.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// True if two closed triangles have a point in common. Degenerate triangles count as segments or
/// points. Tests compare with a linear program on integers.
bool triangles_intersect(const Triangle& a, const Triangle& b);

}  // namespace trivet
