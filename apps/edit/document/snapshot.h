// The scene as the windows see it: immutable, so that it can be read while an operation runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/edit/document/settled_way.h"
#include "ops/placement/interference.h"

namespace trivet::edit {

/// One object as it was; shared by all snapshots until it changes. Model and shape are shared by
/// all objects of one model: their addresses (Shape::id) are keys for what a renderer keeps.
struct ObjectSnapshot {
  ObjectId id;
  std::shared_ptr<const Object> object;  // never null
  std::uint64_t revision = 0;            // of the snapshot in which it changed last

  const Object* operator->() const { return object.get(); }
};

/// What is being dragged, where the hand has it. Nothing of it is committed.
struct DragSnapshot {
  std::vector<ObjectId> moving;        // the object first, then what it carries
  std::vector<ContactPoint> contacts;  // of what moves with the rest, now; may be empty
  bool blocked = false;                // does not follow the hand any further
  OperationResult::End end = OperationResult::End::Reached;
  Named blocked_by;                // its name is empty when nothing did
  Vec3 blocked_at = Vec3::Zero();  // world
  InterferingFaces faces;          // that block it, or that cross in a free move
};

/// An object that moved freely into others, with the faces that cross.
struct InvalidObject {
  ObjectId id;
  InterferingFaces faces;
};

struct SceneSnapshot {
  std::uint64_t revision = 0;   // grows with every change of what is seen, drags too
  std::uint64_t committed = 0;  // grows with every change of the scene: steps, undo, files
  bool floor = true;
  double clearance = 0;                         // metres, by which it is judged; 0: the default
  std::vector<ObjectSnapshot> objects;          // in the order of Scene::ids(); unplaced ones too
  std::vector<std::uint32_t> position_of_slot;  // in `objects`, by ObjectId::index; see find()
  std::shared_ptr<const LoadSupport> support;   // of the committed scene; never null
  std::shared_ptr<const std::vector<InvalidObject>> invalid;  // of it too; null: none
  std::shared_ptr<const SettledWay> way;  // that the last operation took; null: none to be watched
  std::optional<DragSnapshot> drag;       // then the poses of what moves are those in the hand, and
                                          // the links of these objects are as before the drag

  /// Null: there is none.
  const ObjectSnapshot* find(ObjectId id) const;
  const ObjectSnapshot* find(const std::string& name) const;
  /// World box of the placed objects; may be a little larger.
  Aabb box() const;
};

/// World box of one object, from the root of its shape's tree; holds all vertices.
Aabb world_box(const Object& object);

}  // namespace trivet::edit
