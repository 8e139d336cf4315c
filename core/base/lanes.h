// Two doubles at a time: each lane is computed as a lone double would be, bit for bit. Private.
#pragma once

#include <array>

#include "core/base/types.h"

namespace trivet {

/// Extensions of gcc and clang: a register on processors that have such, two doubles elsewhere.
/// Comparisons give a Mask2, and `mask ? x : y` chooses lane by lane: both are computed.
using Double2 = double __attribute__((vector_size(16)));
using Mask2 = std::int64_t __attribute__((vector_size(16)));

inline Double2 both(double x) { return Double2{x, x}; }
inline Double2 swapped(Double2 x) { return Double2{x[1], x[0]}; }
inline bool any(Mask2 m) { return (m[0] | m[1]) != 0; }

/// As std::min() and std::max(): of equal ones the first.
inline Double2 min(Double2 a, Double2 b) { return b < a ? b : a; }
inline Double2 max(Double2 a, Double2 b) { return a < b ? b : a; }
inline Double2 abs(Double2 x) { return (Double2)((Mask2)x & ~(Mask2)both(-0.0)); }
/// x, negative where it has another sign than y.
inline Double2 times_sign(Double2 x, Double2 y) {
  return (Double2)((Mask2)x ^ ((Mask2)y & (Mask2)both(-0.0)));
}

/// Two vectors.
struct Vec3Lanes {
  std::array<Double2, 3> coordinates;

  Double2& operator[](int k) { return coordinates[k]; }
  const Double2& operator[](int k) const { return coordinates[k]; }
};

inline Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3Lanes operator*(Double2 s, const Vec3Lanes& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Vec3Lanes abs(const Vec3Lanes& a) { return {abs(a[0]), abs(a[1]), abs(a[2])}; }

/// Sums as Eigen's of a Vec3: z last.
inline Double2 dot(const Vec3Lanes& a, const Vec3Lanes& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Double2 squared_norm(const Vec3Lanes& a) { return dot(a, a); }
inline Vec3Lanes cross(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vec3Lanes lanes(const Vec3& a, const Vec3& b) {
  return {Double2{a.x(), b.x()}, Double2{a.y(), b.y()}, Double2{a.z(), b.z()}};
}
inline Vec3 lane(const Vec3Lanes& v, int k) { return {v[0][k], v[1][k], v[2][k]}; }

}  // namespace trivet
