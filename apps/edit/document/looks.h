// Appearance of objects in the editor: hidden, not selectable, in a colour, alone or by
// collections. Saved with the scene; steps of the document's history (look_steps.h), not of the
// session's.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "apps/edit/document/collections.h"
#include "ops/files/layout/scene_looks.h"

namespace trivet::edit {

struct SceneSnapshot;

using LookColour = std::array<float, 3>;  // sRGB, 0 to 1

struct Look {
  bool hidden = false;          // still in the scene: others touch it
  bool not_selectable = false;  // tools pass through it, but PUT puts on it
  std::optional<LookColour> colour;
  friend bool operator==(const Look&, const Look&) = default;
};

class Looks {
 public:
  Collections collections;

  /// Its own, whatever its collection; the default one unless it was changed.
  Look of(ObjectId id) const;
  void change(ObjectId id, const Look& look);
  /// Gives an object the look and the collection of another one, as far as it has none.
  void inherit(ObjectId from, ObjectId to);
  /// Objects whose looks of their own are others there, each once.
  std::vector<ObjectId> differing(const Looks& other) const;
  /// With what differs between two others as the second one has it: looks by object, all
  /// collections together.
  Looks changed(const Looks& from, const Looks& to) const;
  /// With what its collection says.
  Look shown(ObjectId id) const;
  /// Hidden objects, including those of hidden collections.
  std::vector<ObjectId> hidden() const;
  /// The hidden ones, too.
  std::vector<ObjectId> not_selectable() const;
  friend bool operator==(const Looks&, const Looks&) = default;

  /// As files have them. @param name_of  of an object; empty: it is gone.
  SceneLooks named(const std::function<std::string(ObjectId)>& name_of) const;
  /// Names that the scene does not have are left out.
  static Looks of_file(const SceneLooks& looks, const SceneSnapshot& scene);

 private:
  std::vector<ObjectId> those(const std::function<bool(const Look&)>& wanted) const;

  using Key = std::pair<std::uint32_t, std::uint32_t>;  // slot, generation
  std::map<Key, Look> m_looks;
};

/// Names of the objects of a snapshot, for Looks::named().
std::function<std::string(ObjectId)> names_in(const SceneSnapshot& scene);

}  // namespace trivet::edit
