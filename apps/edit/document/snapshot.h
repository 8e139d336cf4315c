// Immutable copy of the scene for the windows, readable while an operation runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/edit/document/projection_volume.h"
#include "apps/edit/document/settled_way.h"
#include "ops/placement/interference.h"

namespace trivet::edit {

/// Copy of one object; shared by all snapshots until it changes. Model and shape are shared by all
/// objects of one model: their addresses (Shape::id) serve as cache keys for renderers.
struct ObjectSnapshot {
  ObjectId id;
  std::shared_ptr<const Object> object;  // never null
  std::uint64_t revision = 0;            // of the snapshot of its last change

  const Object* operator->() const { return object.get(); }
};

/// State of a drag. Not committed.
struct DragSnapshot {
  std::vector<ObjectId> moving;   // the object first, then its loads
  std::vector<Contact> contacts;  // between the moving objects and the rest; may be empty
  ProjectionVolume volume;        // of the motion; empty before the first one
  bool blocked = false;           // cannot follow the goal any further
  OperationResult::End end = OperationResult::End::Reached;
  Named blocked_by;                // its name is empty when nothing did
  Vec3 blocked_at = Vec3::Zero();  // world
  InterferingFaces faces;          // blocking faces, or crossing ones in a free move
};

/// An object that was moved freely into others, with the crossing faces.
struct InvalidObject {
  ObjectId id;
  InterferingFaces faces;
};

struct SceneSnapshot {
  std::uint64_t revision = 0;   // grows with every visible change, including drags
  std::uint64_t committed = 0;  // grows with every change of the scene: steps, undo, files
  bool floor = true;
  double clearance = 0;                 // metres, used for judging; 0: the default
  std::vector<ObjectSnapshot> objects;  // in the order of Scene::ids(); includes unplaced ones
  std::vector<std::uint32_t> position_of_slot;  // in `objects`, by ObjectId::index; see find()
  std::shared_ptr<const LoadSupport> support;   // of the committed scene; never null
  std::shared_ptr<const std::vector<InvalidObject>> invalid;  // of the committed scene; null: none
  std::shared_ptr<const Object> falling;  // cloth or cable that comes down, not in the scene; null:
                                          // none
  std::shared_ptr<const SettledWay> way;  // path of the last operation; null: none to play back
  std::optional<DragSnapshot> drag;  // if set, poses of moving objects are the dragged ones, and
                                     // their contacts are those before the drag

  /// Null if not found.
  const ObjectSnapshot* find(ObjectId id) const;
  const ObjectSnapshot* find(const std::string& name) const;
  /// World box of the placed objects; may be slightly too large.
  Aabb box() const;
};

/// The object and all that it carries, transitively: what moves with it.
std::vector<ObjectId> with_loads(const SceneSnapshot& scene, ObjectId object);

/// World box of one object, from the root of its BVH; contains all vertices.
Aabb world_box(const Object& object);

}  // namespace trivet::edit
