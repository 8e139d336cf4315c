// The way on which an operation brought its object to where it is, to be watched.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

struct SettledWay {
  std::vector<ObjectId> moved;  // the object first, then what it carried as one rigid body
  std::vector<Pose> poses;      // of the object, from its start to its end: two at least
  std::vector<double> lengths;  // metres from the start to each: of the object's middle, and of
                                // its rim when it turns
  double size = 0;              // metres, the object's diagonal

  double length() const { return lengths.back(); }
};

/// Nothing: it did not move, or nobody saw how.
/// @param scene  after it. @param steps  that are to be watched. @param from  where they began;
/// nothing: of a PUT where it says, else where the first step tells.
std::optional<SettledWay> settled_way(const Scene& scene, const Operation& operation,
                                      const OperationResult& result,
                                      std::span<const SettleStep> steps,
                                      const std::optional<Pose>& from);

/// Where the object is on its way. @param part  of the length, 0 to 1.
Pose pose_on(const SettledWay& way, double part);

}  // namespace trivet::edit
