#pragma once

#include "core/base/types.h"

namespace trivet {

/// Twice the signed area of the triangle 0, a, b: positive if b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace trivet
