// Two doubles at a time: each lane is computed as a lone double would be, bit for bit. Private.
#pragma once

#include "core/base/types.h"

namespace trivet {

/// Extensions of gcc and clang: a register on processors that have such, two doubles elsewhere.
/// Comparisons give a Mask2, and `mask ? x : y` chooses lane by lane: both are computed.
using Double2 = double __attribute__((vector_size(16)));
using Mask2 = std::int64_t __attribute__((vector_size(16)));

inline Double2 both(double x) { return Double2{x, x}; }
inline bool any(Mask2 m) { return (m[0] | m[1]) != 0; }

/// Two vectors.
struct Vec3Lanes {
  Double2 x, y, z;
};

inline Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3Lanes operator*(Double2 s, const Vec3Lanes& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Sums as Eigen's of a Vec3: z last.
inline Double2 dot(const Vec3Lanes& a, const Vec3Lanes& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Double2 squared_norm(const Vec3Lanes& a) { return dot(a, a); }
inline Vec3Lanes cross(const Vec3Lanes& a, const Vec3Lanes& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Vec3Lanes lanes(const Vec3& a, const Vec3& b) {
  return {Double2{a.x(), b.x()}, Double2{a.y(), b.y()}, Double2{a.z(), b.z()}};
}
inline Vec3 lane(const Vec3Lanes& v, int k) { return {v.x[k], v.y[k], v.z[k]}; }

}  // namespace trivet
