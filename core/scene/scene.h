// The scene: objects in their poses, how they are found, and what rests on what.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/index.h"
#include "core/scene/object.h"

namespace trivet {

class SceneChange;
class Transaction;
using SceneExtent = ObjectTree::Extent;

/// Objects in slots. A floor at z = 0 is optional; gravity is along -z. Objects are changed by a
/// Transaction only. Const functions are pure: any number of threads may call them.
class Scene {
 public:
  bool floor = true;
  PhysicsMaterial floor_material;
  PairKind floor_kind = 0;
  std::shared_ptr<const PairRules> pair_rules;  // of kinds of objects and the floor; null: none

  /// Strong guarantee. @throws Error (BadInput) when the name is empty or taken.
  ObjectId add(Object object);
  /// Objects that touched it lose their contacts with it. Strong guarantee.
  void remove(ObjectId id);
  bool contains(ObjectId id) const;
  const Object& at(ObjectId id) const;  // asserts that the id is alive
  size_t num_objects() const { return m_num_objects; }
  std::vector<ObjectId> ids() const;  // in the order of their addition: the scene's order
  /// Into the scene's order.
  void sort(std::vector<ObjectId>& ids) const;
  /// Cost O(1).
  std::optional<ObjectId> find(const std::string& name) const;

  /// World box of the placed objects; holds all vertices, may be a little larger. Cost O(1).
  Aabb box() const { return m_index.tree().extent().box; }
  /// The same of one object; empty when it is not placed. Cost O(1).
  Aabb world_box(ObjectId id) const;
  /// Box of the placed objects but these, and the smallest diagonal (scale times that of the
  /// shape's box) above zero: metres, infinity if there is none. Cost O(k log n).
  SceneExtent extent_without(std::span<const ObjectId> left_out) const;
  /// The same of the objects whose world box overlaps `box` by the margin in metres, wholly. Cost
  /// O(log n) where that is all or little, else up to O(n).
  SceneExtent extent_near(const Aabb& box, double margin) const;
  /// Placed objects whose world box overlaps `box`, closed, by the margin in metres; in the scene's
  /// order. Cost O(log n) and what is found.
  std::vector<ObjectId> near(const Aabb& box, double margin = 0) const;
  /// The same: calls visitor(id), in an order that means nothing.
  template <class Visitor>
  void visit_near(const Aabb& box, double margin, const Visitor& visitor) const {
    m_index.tree().visit(
        [&](const ObjectTree::Extent& there) { return overlaps(there.box, box, margin); },
        [&](Index slot) { visitor(id_of(slot)); });
  }
  /// Objects that lean (see leans()) and whose world box overlaps `box` by the margin of their own
  /// size; in the scene's order. Cost O(log n) and what is found.
  std::vector<ObjectId> leaning_near(const Aabb& box) const;
  /// Objects in ObjectState::Invalid, placed or not; in the scene's order. Cost O(found log found).
  std::vector<ObjectId> invalid_objects() const;
  /// Objects of this group, placed or not; in the scene's order. Of no name: none.
  std::vector<ObjectId> group_members(const std::string& group) const;

  /// Brings back what `change` holds and lets it hold what was there: undo, and the next time redo,
  /// to the bit, ids too. The scene must be as it was when the change was committed (or, the next
  /// time, when its transaction began), and no transaction be open. Allocates nothing.
  void exchange(SceneChange& change) noexcept;

  /// Deep validator, for tests: whether all that is looked up agrees with the objects.
  bool is_consistent() const;

 private:
  friend class SceneChange;
  friend class Transaction;
  struct Slot {
    std::uint32_t generation = 0;
    std::optional<Object> object;
    std::uint64_t order = 0;
  };
  /// The innermost open transaction's change. Belongs to this scene: copies have none.
  struct Open {
    SceneChange* change = nullptr;

    Open() = default;
    Open(const Open&) noexcept {}
    Open& operator=(const Open&) noexcept;
  };

  ObjectId id_of(Index slot) const {
    return {static_cast<std::uint32_t>(slot), m_slots[slot].generation};
  }
  /// Keeps the slot as it is, for the open transaction. Strong guarantee.
  void keep(size_t index);
  /// To be called when a slot has changed.
  void refresh(size_t index) noexcept;
  void swap_with(SceneChange& change) noexcept;
  void set_contacts(ObjectId id, std::vector<ObjectContact> object_contacts);

  std::vector<Slot> m_slots;
  std::vector<std::uint32_t> m_generations;  // the last of each slot; undo does not take them back
  std::uint64_t m_next_order = 0;
  size_t m_num_objects = 0;
  SceneIndex m_index;
  Open m_open;
};

/// The other state of all that a transaction changed. See Scene::exchange().
class SceneChange {
 public:
  bool empty() const { return m_slots.empty(); }
  /// The objects that this holds: those that an exchange brings back. Sorted by slot.
  std::vector<ObjectId> ids() const;

 private:
  friend class Scene;
  friend class Transaction;
  std::map<size_t, Scene::Slot> m_slots;  // by index
  std::uint64_t m_next_order = 0;
};

/// The same contact seen from the other object.
Contact reversed(const Contact& contact);

/// Load-support list: supports and loads of every object, derived from the contacts.
struct LoadSupport {
  struct Entry {
    ObjectId object;
    bool on_floor = false;
    std::vector<ObjectId> supports, loads;  // sorted by slot
  };
  std::vector<Entry> entries;  // placed objects, in the order of Scene::ids()
};

/// True if a contact, seen from one object, may carry it; true if it may lie on the other.
/// Of an uneven contact both may be true.
bool holds_up(const Contact& contact);
bool weighs_on(const Contact& contact);
/// The same of a link: by its normals, or by the forces that hold one of the two.
bool holds_up(const ObjectContact& entry);
bool weighs_on(const ObjectContact& entry);

/// Supports of an object, and theirs in turn, that would move or do not count as they are: held by
/// a hand, unsupported or invalid. In the scene's order. What is fixed needs none. Cost of what is
/// below.
std::vector<ObjectId> unsound_supports(const Scene& scene, ObjectId id);

/// A supports B when B touches A and the contact's normal points up from A to B (normal.z of the
/// contact, or of one of its points, above kSupportNormalZ), or B leans and the forces that hold it
/// come from A.
LoadSupport load_support(const Scene& scene);
inline constexpr double kSupportNormalZ = 1e-3;

}  // namespace trivet
