#include "apps/edit/document/object_changes.h"

namespace trivet::edit {

ObjectChanges changes_between(const SceneSnapshot& before, const SceneSnapshot& now) {
  ObjectChanges out;
  std::map<std::string, ObjectId> gone;
  for (const ObjectSnapshot& old : before.objects) {
    const ObjectSnapshot* const same = now.find(old.id);
    if (!same)
      gone[old->name] = old.id;
    else if ((*same)->name != old->name)
      out.renamed[old->name] = (*same)->name;
  }
  if (gone.empty()) return out;
  for (const ObjectSnapshot& object : now.objects)
    if (const auto found = gone.find(object->name); found != gone.end() && !before.find(object.id))
      out.remade.emplace_back(found->second, object.id);
  return out;
}

}  // namespace trivet::edit
