#include "apps/edit/document/selection.h"

#include <algorithm>

#include "ops/operations/turn_axis.h"

namespace trivet::edit {

bool Selection::contains(ObjectId id) const {
  return std::find(objects.begin(), objects.end(), id) != objects.end();
}

std::optional<ObjectId> Selection::active() const {
  if (objects.empty()) return std::nullopt;
  return objects.back();
}

std::vector<std::string> selected_names(const Selection& selection, const SceneSnapshot& scene) {
  std::vector<std::string> names;
  for (const ObjectId id : selection.objects)
    if (const ObjectSnapshot* const object = scene.find(id)) names.push_back((*object)->name);
  return names;
}

std::vector<std::string> selected_beside_active(const Selection& selection,
                                                const SceneSnapshot& scene) {
  std::vector<std::string> names;
  for (const ObjectId id : selection.objects) {
    const ObjectSnapshot* const object = scene.find(id);
    if (object && (*object)->placed && id != selection.active()) names.push_back((*object)->name);
  }
  return names;
}

Selection pruned(Selection selection, const SceneSnapshot& scene) {
  std::erase_if(selection.objects, [&](ObjectId id) { return !scene.find(id); });
  if (!selection.contact) return selection;
  const auto active = selection.active();
  const ObjectSnapshot* const object = active ? scene.find(*active) : nullptr;
  const auto still = [&](const ObjectContact& entry) {
    return entry.with == selection.contact->with;
  };
  if (!object || std::none_of((*object)->contacts.begin(), (*object)->contacts.end(), still))
    selection.contact.reset();
  return selection;
}

const ObjectContact* active_object_contact(const Selection& selection, const SceneSnapshot& scene) {
  const auto active = selection.active();
  const ObjectSnapshot* const object = active ? scene.find(*active) : nullptr;
  if (!object) return nullptr;
  const ObjectContact* best = nullptr;
  for (const ObjectContact& entry : (*object)->contacts) {
    if (selection.contact && entry.with == selection.contact->with) return &entry;
    if (!best || holds_more(entry, *best)) best = &entry;
  }
  return best;
}

}  // namespace trivet::edit
