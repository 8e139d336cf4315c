// All by which a scene finds its objects: boxes, names, groups, states, free slots.
#pragma once

#include <string_view>

#include "core/scene/object.h"
#include "core/scene/object_tree.h"
#include "core/scene/slot_chains.h"

namespace trivet {

/// World box of an object where it stands, and its size; see ObjectTree.
ObjectTree::Extent extent_of(const Object& object);

/// Size of a place that float32 copies of an object still describe well enough to rest in, metres:
/// four diagonals where it may be moved, as others lie beside it; one where it is fixed and turned,
/// as its vertices are rounded; none where it is fixed along the axes, as its faces stay in place.
double coarse_size(const Object& object);

/// Follows the objects: call set() after changing one. Only reserve() allocates.
/// Keeps what it stored about a slot, so that entries are removed without the object.
class SceneIndex {
 public:
  /// Makes room for slots 0 to num_slots - 1; new ones are not known as free yet. Strong guarantee.
  void reserve(size_t num_slots);
  /// @param object  what the slot holds; null: nothing, it is free.
  void set(Index slot, const Object* object) noexcept;

  /// The first of the free slots; -1: there is none.
  Index first_free() const noexcept { return m_free.first(); }
  const ObjectTree& tree() const { return m_tree; }

  /// These call visitor(slot) in an order that means nothing. By name and group: slots with the
  /// same hash, which are to be compared.
  template <class Visitor>
  void visit_named(std::string_view name, const Visitor& visitor) const {
    m_names.visit(hash_of(name), visitor);
  }
  template <class Visitor>
  void visit_group(std::string_view group, const Visitor& visitor) const {
    m_groups.visit(hash_of(group), visitor);
  }
  template <class Visitor>
  void visit_invalid(const Visitor& visitor) const {
    m_invalid.visit(0, visitor);
  }

 private:
  static std::uint64_t hash_of(std::string_view text) noexcept;

  ObjectTree m_tree;  // placed objects
  SlotChains m_names, m_groups;
  SlotChains m_invalid;  // one chain, of ObjectState::Invalid
  SlotSet m_free;
};

}  // namespace trivet
