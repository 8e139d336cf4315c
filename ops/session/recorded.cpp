#include "ops/session/recorded.h"

#include "ops/files/report/geometry.h"

namespace trivet {

RecordedPoses recorded_poses(const Scene& scene, const std::vector<ObjectId>& ids) {
  RecordedPoses out;
  for (const ObjectId id : ids) {
    if (!scene.contains(id)) continue;
    const Object& object = scene.at(id);
    out.push_back({object.name, object.placed ? std::optional(object.pose) : std::nullopt});
  }
  return out;
}

RecordedModel recorded_model(const Model& model) {
  return {{model.path, model.tessellation},
          model.up,
          geometry_fingerprint(model.mesh),
          model.mesh.box()};
}

}  // namespace trivet
