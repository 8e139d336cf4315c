// Collections: objects under one name, to be hidden, made not selectable and selected together.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/support.h"

namespace trivet::edit {

struct Collection {
  std::string name;  // unique, not empty
  bool hidden = false, not_selectable = false;
  std::vector<ObjectId> objects = {};  // some may be gone; undo brings them back
  friend bool operator==(const Collection&, const Collection&) = default;
};

/// An object is in one collection at most. Operations know nothing of them.
class Collections {
 public:
  const std::vector<Collection>& all() const { return m_all; }
  const Collection* find(const std::string& name) const;  // null: none
  const Collection* of(ObjectId id) const;                // null: in none
  /// "collection 1" of "collection": the first that is free.
  std::string free_name(const std::string& like) const;

  /// Puts the objects into the collection of this name, which is made if there is none, and out of
  /// all others.
  void put(std::span<const ObjectId> objects, const std::string& name);
  void take_out(std::span<const ObjectId> objects);
  /// Puts `to` beside `from` into its collection, unless it is in one.
  void inherit(ObjectId from, ObjectId to);
  /// @return false, and nothing changes: there is no such collection, or `to` is empty or taken.
  bool rename(const std::string& name, const std::string& to);
  void show(const std::string& name, bool hidden, bool not_selectable);
  /// Its objects stay.
  void dissolve(const std::string& name);

  friend bool operator==(const Collections&, const Collections&) = default;

 private:
  std::vector<Collection> m_all;
};

}  // namespace trivet::edit
