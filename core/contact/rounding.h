// Thresholds of rounding in double. Private.
#pragma once

namespace trivet {

/// Squared areas below this, of the longest edge to the fourth, give no usable normal.
inline constexpr double kFlat = 1e-20;
/// Distances below this, of the extent of the coordinates, are rounding of 0.
inline constexpr double kRounding = 4e-15;

}  // namespace trivet
