// Vertical lines through an object, and what they meet of it and of others. Private.
#pragma once

#include <vector>

#include "ops/placement/neighbourhood.h"
#include "raster/zlist/complete_zlists.h"

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

/// Lines of sight down through an object, drawn once and read for any tolerance up to a largest
/// one.
class ColumnLists {
 public:
  /// @param object  index into `all`. @param num  columns across the longer side of its box.
  ColumnLists(const Scene& scene, const PosedObjects& all, size_t object, int num,
              double most_tolerance);

  double most_tolerance() const { return m_most_tolerance; }
  /// @param tolerance  metres by which another may reach into it from below.
  Columns read(double tolerance) const;

 private:
  double m_most_tolerance;
  std::vector<ObjectId> m_others;
  std::vector<Body> m_bodies;  // the object, then the others
  std::vector<bool> m_is_solid;
  CompleteZLists m_lists;
};

}  // namespace trivet
