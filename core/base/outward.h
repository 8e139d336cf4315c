// float32 boxes that hold what they bound: the one conversion from double.
#pragma once

#include <cmath>

#include "core/base/types.h"

namespace trivet {

/// The largest float not above x.
inline float float_below(double x) {
  const float f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

/// The smallest float not below x.
inline float float_above(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

/// The smallest box of floats that holds `box`.
inline Aabb rounded_outwards(const Aabb& box) {
  Aabb out;
  for (int k = 0; k < 3; ++k) {
    out.lower[k] = float_below(box.lower[k]);
    out.upper[k] = float_above(box.upper[k]);
  }
  return out;
}

}  // namespace trivet
