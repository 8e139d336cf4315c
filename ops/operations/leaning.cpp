#include "ops/operations/leaning.h"

namespace trivet {

std::vector<ObjectId> leaning_on(const Scene& scene, const Object& object,
                                 const Neighbourhood& outside) {
  if (!object.placed) return {};
  std::vector<ObjectId> out = scene.leaning_near(body_of(object).world_box);
  std::erase_if(out, [&](ObjectId id) { return outside.excludes(id); });
  return out;
}

bool leans_on_any(const Object& object, const Neighbourhood& outside) {
  if (!object.placed || !leans(object)) return false;
  const Aabb box = body_of(object).world_box;
  const double reach = size_of(object);
  return (outside.scene().floor && box.lower.z() <= reach) || !outside.ids_near(box, reach).empty();
}

}  // namespace trivet
