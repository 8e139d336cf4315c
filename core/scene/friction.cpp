#include "core/scene/friction.h"

namespace trivet {

const PhysicsMaterial& material_of(const Scene& scene, const Support& support) {
  return support.is_floor() ? scene.floor_material : scene.at(support.object()).material;
}

double friction_between(const Scene& scene, ObjectId object, const Support& with) {
  return pair_friction(scene.at(object).material, material_of(scene, with));
}

}  // namespace trivet
