// Whom a move takes along, and whom it may not move.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "ops/base/options.h"
#include "ops/base/refusal.h"

namespace trivet {

/// The object, its loads, transitively [Shinya 1995, 4.2], the members of their groups and what
/// hangs in them by joints, with their loads. The object first, the others by slot. Fixed objects
/// are never carried, but in joints.
/// @param together  in the scene, treated as members of the object's group.
/// @param more_loads  that no link shows, with all that they carry.
std::vector<ObjectId> carried_with(const Scene& scene, ObjectId object,
                                   std::span<const ObjectId> together = {},
                                   std::span<const ObjectId> more_loads = {});

/// Loads of carried_with() that no link shows: forces that balance the whole have its members carry
/// them. None with perfect friction.
std::vector<ObjectId> loads_by_forces(const Scene& scene, ObjectId object,
                                      std::span<const ObjectId> together,
                                      const SettleOptions& options);

/// Objects that a hand moves: the object, those `together` with it, their groups, and what hangs in
/// them. The rest of carried_with() only lies on these.
std::vector<ObjectId> driven_with(const Scene& scene, ObjectId object,
                                  std::span<const ObjectId> together = {});

/// Refuses to move fixed and locked objects; links may go with what they hang in.
/// @param ids  the object of the operation first. @param in_joint  that one moves in its joint.
std::optional<Refusal> refuse_immovable(const Scene& scene, std::span<const ObjectId> ids,
                                        bool in_joint = false);

}  // namespace trivet
