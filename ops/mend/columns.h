// Vertical lines through an object, and what they meet of it and of others. Private.
#pragma once

#include <vector>

#include "ops/placement/neighbourhood.h"

namespace trivet {

inline constexpr double kNoHeight = -kInfinity;

/// A line meets this of another object. Heights, metres; kNoHeight: nothing.
struct MetObject {
  double highest_under = kNoHeight;  // of its faces that look up, not above the object's underside
                                     // by more than the tolerance
  double low = kInfinity, high = kNoHeight;
};
struct Column {
  Vec2 at;           // world
  double low, high;  // of the object
  std::vector<MetObject> others;
};
struct Columns {
  double width = 0;              // of a column, metres
  std::vector<ObjectId> others;  // in the scene's order
  std::vector<Column> columns;   // those that meet the object
};

/// An object and its pose, which need not be the one in the scene.
using PosedObjects = std::vector<Placement>;

/// @param object  index into `all`. @param num  columns across the longer side of its box.
/// @param tolerance  metres by which another may reach into it from below.
Columns columns_of(const Scene& scene, const PosedObjects& all, size_t object, int num,
                   double tolerance);

}  // namespace trivet
