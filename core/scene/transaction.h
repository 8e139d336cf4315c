// All or nothing: the only way to change the objects of a scene.
#pragma once

#include <utility>

#include "core/scene/scene.h"

namespace trivet {

/// Without commit(), the destructor rolls back all changes since construction, to the bit, ids too:
/// a rollback allocates nothing and cannot fail. Objects are kept as they were at their first
/// change, so that the cost is theirs, not the scene's. Scene::floor and
/// Scene::floor_material are not watched.
///
/// Transactions nest, the last one opened ends first: an inner one commits into the outer one, and
/// takes back what was done since its own beginning only. While an inner one is open, the outer one
/// is not used.
class Transaction {
 public:
  /// @param scene  outlives this and stays where it is.
  explicit Transaction(Scene& scene) noexcept;
  /// Nested in `outer`, of the same scene.
  explicit Transaction(Transaction& outer) noexcept : Transaction(outer.m_scene) {}
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  const Scene& scene() const { return m_scene; }

  /// See Scene. Each has the strong guarantee.
  ObjectId add(Object object);
  void remove(ObjectId id);
  /// Replaces what the object touches; those it touches see the same contact from their side.
  /// Costs what the object touched and touches, not the scene.
  void set_contacts(ObjectId id, std::vector<ObjectContact> object_contacts);
  void clear_contacts(ObjectId id) { set_contacts(id, {}); }

  /// Calls change(Object&), which may give a name that no object has; contacts by set_contacts().
  /// If it throws, its changes stay in the scene until the rollback.
  template <class Change>
  void edit(ObjectId id, Change&& change) {
    const Refresh refresh(*this, id);
    std::forward<Change>(change)(refresh.object());
  }

  /// The objects that were changed, added or removed since, those that are gone too, and perhaps
  /// some that are the same again. Sorted by slot, then generation.
  std::vector<ObjectId> touched() const;

  /// Takes everything back now, and ends this.
  void rollback() noexcept;
  /// Ends this for good. @return what undoes it; of an inner transaction: empty, the outer one has
  /// it now.
  SceneChange commit() noexcept;

 private:
  // Keeps an object that is about to change, and brings the scene up to date afterwards.
  class Refresh {
   public:
    Refresh(Transaction& transaction, ObjectId id);
    ~Refresh();
    Refresh(const Refresh&) = delete;
    Refresh& operator=(const Refresh&) = delete;
    Object& object() const;

   private:
    Scene& m_scene;
    size_t m_index;
  };

  bool is_innermost() const { return m_open && m_scene.m_open.change == &m_before; }

  Scene& m_scene;
  SceneChange m_before;
  SceneChange* m_outer;
  bool m_open = true;
};

/// Changes one object, or nothing when `change` throws: a transaction of one edit().
template <class Change>
void edit_object(Scene& scene, ObjectId id, Change&& change) {
  Transaction transaction(scene);
  transaction.edit(id, std::forward<Change>(change));
  transaction.commit();
}

}  // namespace trivet
