// Outcomes of steps as a journal records them: enough to bring them back when models have changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/files/layout/load.h"

namespace trivet {

struct RecordedPose {
  std::string object;
  std::optional<Pose> pose;  // nullopt: out of the scene
};
using RecordedPoses = std::vector<RecordedPose>;

/// A model as it was when an object of it came.
struct RecordedModel {
  ModelRequest request;
  UpAxis up = UpAxis::Z;
  std::string fingerprint;  // geometry_fingerprint() of its mesh
  Aabb box;                 // of its mesh
};
using RecordedModels = std::vector<RecordedModel>;

/// Poses of the objects that are in the scene's list.
RecordedPoses recorded_poses(const Scene& scene, const std::vector<ObjectId>& ids);

/// @param model  from a file.
RecordedModel recorded_model(const Model& model);

}  // namespace trivet
