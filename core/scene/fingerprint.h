// Scenes compared by one number: the same bits give the same hash.
#pragma once

#include <span>
#include <vector>

#include "core/base/hash.h"
#include "core/scene/scene.h"

namespace trivet {

/// Adds all of an object but its geometry: name, material, pose, state, rating, lock, group, links
/// with all their contact points.
void add_to(Hash& hash, const Object& object);

/// Hash of these objects, including those that are gone. Cost: the objects, not the scene.
std::uint64_t fingerprint(const Scene& scene, std::span<const ObjectId> ids);
/// Hash of the whole scene, in the order of ids().
std::uint64_t fingerprint(const Scene& scene);

/// One number of a scene that changes, kept up to date at the cost of what changes: the sum of the
/// hashes of objects and their slots, whatever the order. The same state gives the same number,
/// however it was reached and on every machine. It is not that of fingerprint().
class SceneState {
 public:
  explicit SceneState(const Scene& scene);

  /// @param changed  at least the objects that came, went or changed since the last call.
  void update(const Scene& scene, std::span<const ObjectId> changed);
  /// Cost O(1).
  std::uint64_t value(const Scene& scene) const;

 private:
  struct Slot {
    std::uint32_t generation = 0;
    std::uint64_t hash = 0;  // 0: empty
  };
  std::vector<Slot> m_slots;
  std::uint64_t m_sum = 0;  // of the hashes, modulo 2^64
};

}  // namespace trivet
