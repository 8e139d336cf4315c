// Selected objects and the active contact, which TURN turns about and the constraint window looks
// along.
#pragma once

#include <optional>
#include <vector>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// A contact of the active object, identified by the other object.
struct ActiveContact {
  enum class Part { Area, Edge, Point };
  Support with;
  Part part = Part::Area;    // held part: all of it, an edge of its hull, or a point
  Vec3 near = Vec3::Zero();  // world; selects the nearest edge or point

  friend bool operator==(const ActiveContact&, const ActiveContact&) = default;
};

struct Selection {
  std::vector<ObjectId> objects;  // the last one is active
  std::optional<ActiveContact> contact;

  bool contains(ObjectId id) const;
  std::optional<ObjectId> active() const;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Names of the selected objects, placed or not.
std::vector<std::string> selected_names(const Selection& selection, const SceneSnapshot& scene);

/// Names of the selected objects in the scene that move along with the active one.
std::vector<std::string> selected_beside_active(const Selection& selection,
                                                const SceneSnapshot& scene);

/// Drops missing objects and ended contacts.
Selection pruned(Selection selection, const SceneSnapshot& scene);

/// Contact of the active selection; else, among the contacts that support the active object, the
/// largest. Null: none.
const ObjectContact* active_object_contact(const Selection& selection, const SceneSnapshot& scene);

}  // namespace trivet::edit
