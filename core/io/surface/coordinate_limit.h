// The farthest coordinate that is read.
#pragma once

namespace trivet {

inline constexpr double kMaxCoordinate = 1e30;  // squares and cubes of it stay finite in double

}  // namespace trivet
