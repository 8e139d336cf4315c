#include "apps/edit_document/scene_checks.h"

#include "core/scene/fingerprint.h"
#include "ops/check/check.h"

namespace trivet::edit::test {

std::uint64_t fingerprint(const SceneSnapshot& scene) {
  Hash hash;
  for (const ObjectSnapshot& o : scene.objects) {
    hash.add(std::uint64_t{o.id.index}).add(std::uint64_t{o.id.generation});
    add_to(hash, *o.object);
  }
  return hash.value();
}

std::string wrong_with(const SceneSnapshot& snapshot) {
  Scene scene;
  scene.floor = snapshot.floor;
  for (const ObjectSnapshot& o : snapshot.objects) {
    Object object = *o.object;
    object.contacts.clear();
    scene.add(std::move(object));
  }
  const SceneCheck check = check_scene(scene, 1, snapshot.clearance);
  for (const auto* findings : {&check.crossings, &check.float32_crossings, &check.contained})
    for (const SceneCheck::PairFinding& f : *findings) {
      const ObjectSnapshot* const a = snapshot.find(f.a);
      const ObjectSnapshot* const b = snapshot.find(f.b);
      if ((a && (*a)->state == ObjectState::Invalid) || (b && (*b)->state == ObjectState::Invalid))
        continue;
      return f.a + " interpenetrates " + f.b;
    }
  for (const std::string& name : check.not_at_rest)
    if ((*snapshot.find(name))->state == ObjectState::Stable) return name + " is not at rest";
  return "";
}

}  // namespace trivet::edit::test
