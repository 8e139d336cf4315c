// Objects of a layout by the names that its operations leave them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/files/layout/layout.h"

namespace trivet {

/// A name that an operation gives to an object, and the key that has it in JSON.
struct GivenName {
  const char* key;
  const std::string* name;  // of the operation
};
/// Nullopt for operations that give none.
std::optional<GivenName> given_name(const Operation& operation);

/// Appended, duplicated, renamed and deleted objects; other operations leave names as they are.
class NamedObjects {
 public:
  /// Before the first operation.
  explicit NamedObjects(const std::vector<LayoutObject>& objects);

  /// @return false, with all as it was: the object is not there, or the new name is taken.
  bool follow(const Operation& operation);

  bool contains(const std::string& name) const { return m_index.count(name) != 0; }
  /// As the layout has it: a duplicate as its original, out of the scene and not fixed. Null:
  /// there is none of this name.
  const LayoutObject* find(const std::string& name) const;
  /// In the order in which they came.
  std::vector<std::string> names() const;

 private:
  void add(LayoutObject object);

  std::map<std::string, size_t> m_index;
  std::vector<std::optional<LayoutObject>> m_objects;  // nothing: deleted
};

/// After all operations of a layout, of which none was refused.
NamedObjects objects_after(const Layout& layout);
/// After those that were not refused, as far as the names in the scene tell.
NamedObjects objects_in(const Scene& scene, const Layout& layout);

}  // namespace trivet
