// Scenes compared by one number: the same bits give the same hash.
#pragma once

#include <span>

#include "core/base/hash.h"
#include "core/scene/scene.h"

namespace trivet {

/// Adds all of an object but its geometry: name, material, pose, state, rating, lock, group, links
/// with all their contact points.
void add_to(Hash& hash, const Object& object);

/// Of these objects, those that are gone included. Cost: the objects, not the scene.
std::uint64_t fingerprint(const Scene& scene, std::span<const ObjectId> ids);
/// Of the whole scene, in the order of ids().
std::uint64_t fingerprint(const Scene& scene);

}  // namespace trivet
