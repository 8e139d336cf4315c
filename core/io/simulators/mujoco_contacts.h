// Contacts as MuJoCo 3 shall compute them, in MJCF and USD. Private.
#pragma once

namespace trivet {

inline constexpr int kMujocoCondim = 4;  // sliding friction and torsional
/// Time constant, seconds, and damping; stiffness near and beyond a depth, that depth, metres.
/// Overdamped: what is pressed together rises slowly.
inline constexpr const char *kMujocoSolref = "0.004 3", *kMujocoSolimp = "0.995 0.9995 0.0001";

}  // namespace trivet
