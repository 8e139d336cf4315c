// Limits of arguments, in files and in programs alike.
#pragma once

#include <cstdint>

namespace trivet {

/// Lengths, metres, and scales: what float32 export and exact predicates can bear.
inline constexpr double kMaxLength = 1e15;
inline constexpr double kMinScale = 1e-15, kMaxScale = 1e15;
/// A quaternion needs one component of at least this magnitude; it is scaled to unit length.
inline constexpr double kMinQuaternionComponent = 1e-6, kMaxQuaternionComponent = 1e6;
/// A direction needs one component of at least this magnitude, and none beyond the largest.
inline constexpr double kMinDirectionComponent = 1e-6, kMaxDirectionComponent = 1e6;
inline constexpr double kMaxAngleDeg = 3600;
/// Bounds of materials: Coulomb's coefficient, kg/m^3, and the ratio of speeds after and before a
/// bounce.
inline constexpr double kMinFriction = 1e-3, kMaxFriction = 10;
inline constexpr double kMinDensity = 1e-3, kMaxDensity = 1e5;
inline constexpr double kMaxRestitution = 1;
inline constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;

}  // namespace trivet
