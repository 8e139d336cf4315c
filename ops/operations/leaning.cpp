#include "ops/operations/leaning.h"

namespace trivet {

std::vector<ObjectId> leaning_on(const Scene& scene, const Object& object,
                                 const Neighbourhood& outside) {
  // An object out of the scene carries nothing.
  if (!object.placed) return {};
  std::vector<ObjectId> out = scene.leaning_near(body_of(object).world_box);
  std::erase_if(out, [&](ObjectId id) { return outside.excludes(id); });
  return out;
}

}  // namespace trivet
