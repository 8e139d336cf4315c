// Path of an object during an operation, for playback.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

struct SettledWay {
  std::vector<ObjectId> moved;  // the object first, then its rigidly carried loads
  std::vector<Pose> poses;      // of the object, from start to end: at least two
  std::vector<double> lengths;  // metres from the start to each: path of the centre, and of
                                // the rim when the object turns
  double size = 0;              // metres, the object's diagonal

  double length() const { return lengths.back(); }
};

/// Nullopt: it did not move, or the path is unknown.
/// @param scene  after the operation. @param steps  to be played back. @param from  start pose;
///   nullopt: the start of a PUT, else that of the first step.
std::optional<SettledWay> settled_way(const Scene& scene, const Operation& operation,
                                      const OperationResult& result,
                                      std::span<const SettleStep> steps,
                                      const std::optional<Pose>& from);

/// Pose on the path. @param part  fraction of the length, 0 to 1.
Pose pose_on(const SettledWay& way, double part);

}  // namespace trivet::edit
