#include "apps/edit/document/snapshot.h"

#include <algorithm>

#include "core/contact/body.h"

namespace trivet::edit {

const ObjectSnapshot* SceneSnapshot::find(ObjectId id) const {
  if (id.index >= position_of_slot.size()) return nullptr;
  const std::uint32_t position = position_of_slot[id.index];
  return position < objects.size() && objects[position].id == id ? &objects[position] : nullptr;
}

const ObjectSnapshot* SceneSnapshot::find(const std::string& name) const {
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&](const ObjectSnapshot& o) { return o->name == name; });
  return found == objects.end() ? nullptr : &*found;
}

Aabb SceneSnapshot::box() const {
  Aabb box;
  for (const ObjectSnapshot& o : objects)
    if (o->placed) box.extend(world_box(*o.object));
  return box;
}

Aabb world_box(const Object& object) {
  return Body(*object.shape, object.world_from_object()).world_box;
}

std::vector<ObjectId> with_loads(const SceneSnapshot& scene, ObjectId object) {
  std::vector<ObjectId> out{object};
  for (size_t i = 0; i < out.size(); ++i)
    for (const LoadSupport::Entry& e : scene.support->entries) {
      if (!(e.object == out[i])) continue;
      for (const ObjectId load : e.loads)
        if (std::find(out.begin(), out.end(), load) == out.end()) out.push_back(load);
    }
  return out;
}

}  // namespace trivet::edit
