#include "apps/farm/scene/standing.h"

#include "core/scene/transaction.h"

namespace trivet::farm {

Scene standing(const Layout& layout, const LoadedModels& models, const std::string& where) {
  Scene scene = trivet::make_scene(layout, models, where);
  Transaction transaction(scene);
  for (const LayoutObject& wanted : layout.objects)
    transaction.edit(*scene.find(wanted.name), [&](Object& object) {
      object.pose = *wanted.pose;
      object.placed = true;
    });
  transaction.commit();
  return scene;
}

}  // namespace trivet::farm
