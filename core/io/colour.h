// sRGB, as OBJ, FBX, DAE and 3DS store colours, and linear light, as Trivet and glTF do.
#pragma once

#include <algorithm>
#include <cmath>

namespace trivet {

/// Replaces numbers out of range and non-finite ones of broken files.
inline float unit_interval(float value, float otherwise) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

inline float linear_from_srgb(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

inline float srgb_from_linear(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

}  // namespace trivet
