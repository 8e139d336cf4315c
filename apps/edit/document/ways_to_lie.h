// Ways in which an object can lie: its stable poses, each by the least turn from how it lies now.
#pragma once

#include <optional>
#include <vector>

#include "core/scene/object.h"

namespace trivet::edit {

struct WayToLie {
  Rotation rotation;       // of a Pose
  double turn_deg = 0;     // from how it lies now
  double tilt_deg = 0;     // between the model's own up and the world's
  double probability = 0;  // of random rotations that end in it
};

struct WaysToLie {
  ObjectId object;
  std::vector<WayToLie> ways;
};

/// Neighbours of one way differ by no more.
inline constexpr double kSameWayDeg = 12;

/// The nearest first. Poses that follow each other by less than kSameWayDeg, as those of a round
/// side do, are one way: the nearest of them.   Thread-safe.
std::vector<WayToLie> ways_to_lie(const Object& object);

enum class Lying { Next, OnItsSide, Upright };

/// Next: the nearest that is not how it lies now. OnItsSide: the likeliest that is tilted between
/// 45 and 135 degrees. Nullopt: there is none, or it lies so.
std::optional<WayToLie> way_of(const std::vector<WayToLie>& ways, Lying how);

}  // namespace trivet::edit
