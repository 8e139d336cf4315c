// Rounding to float32, and nothing but that.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// The nearest float32. Through memory: gcc 12.2 with -O2 (-ftree-slp-vectorize) drops conversions
/// of pairs of doubles to float and back, as in v.cast<float>().cast<double>().
inline double as_float32(double value) {
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}

inline Vec3 as_float32(const Vec3& v) {
  return {as_float32(v.x()), as_float32(v.y()), as_float32(v.z())};
}

}  // namespace trivet
