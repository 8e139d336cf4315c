#include "core/scene/friction.h"

namespace trivet {
namespace {

const PairRule* rule_of(const Scene& scene, PairKind a, PairKind b) {
  return scene.pair_rules ? scene.pair_rules->find(a, b) : nullptr;
}

PairKind kind_of(const Scene& scene, const Support& support) {
  return support.is_floor() ? scene.floor_kind : scene.at(support.object()).pair_kind;
}

}  // namespace

const PhysicsMaterial& material_of(const Scene& scene, const Support& support) {
  return support.is_floor() ? scene.floor_material : scene.at(support.object()).material;
}

double friction_between(const Scene& scene, const Surface& surface, const Support& with) {
  const PairRule* const rule = rule_of(scene, surface.kind, kind_of(scene, with));
  if (rule && rule->friction) return *rule->friction;
  // The smoother of two surfaces decides.
  return std::min(surface.friction, material_of(scene, with).friction);
}

double friction_between(const Scene& scene, ObjectId object, const Support& with) {
  return friction_between(scene, surface_of(scene.at(object)), with);
}

bool may_pass(const Scene& scene, PairKind a, PairKind b) {
  const PairRule* const rule = rule_of(scene, a, b);
  return rule && rule->may_pass;
}

}  // namespace trivet
