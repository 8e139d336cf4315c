// Which objects are selected, and which contact is active: what TURN is about and what the
// constraint window looks along.
#pragma once

#include <optional>
#include <vector>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// A contact of the active object, by whom it is with.
struct ActiveContact {
  enum class Part { Area, Edge, Point };
  Support with;
  Part part = Part::Area;        // what is held: all of it, an edge of its hull, or a point
  Vec3 near = Vec3::Zero();      // world; the edge or point nearest to this

  friend bool operator==(const ActiveContact&, const ActiveContact&) = default;
};

struct Selection {
  std::vector<ObjectId> objects;  // the last one is active
  std::optional<ActiveContact> contact;

  bool contains(ObjectId id) const;
  std::optional<ObjectId> active() const;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// What else moves when the active object is moved: the names of the other selected objects that
/// are in the scene.
std::vector<std::string> selected_beside_active(const Selection& selection,
                                                const SceneSnapshot& scene);

/// What is still there: objects that are gone and contacts that have ended are left out.
Selection pruned(Selection selection, const SceneSnapshot& scene);

/// The link that the active contact means; else of those that hold the active object up the one
/// with the most contact. Null: there is none.
const Link* active_link(const Selection& selection, const SceneSnapshot& scene);

}  // namespace trivet::edit
