#include "ops/operations/material.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<MaterialOperation>() {
  using P = MaterialOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"material",
        "Set an object's material; nothing moves, but objects that the new friction no longer "
        "holds are reported as unsupported"}},
      {R("material", &P::material, kMaterial, "Name of a preset, or its numbers").needed()});
  return rows;
}

// No object moves; the object and what it touches are rated again.
OperationResult apply(Transaction& transaction, const MaterialOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_named(transaction, o.object);
  transaction.edit(id, [&](Object& object) { object.material = o.material; });
  OperationResult result = done_result();
  // No rest depends on it by these rules; what others have judged stays.
  if (!has_finite_friction(run.options)) return result;
  const RestRules rules =
      rest_rules(run.options, clearance_near(scene, run.options, scene.world_box(id)));
  // The object and its partners may rest, or not, by the new friction.
  std::vector<ObjectId> touched{id};
  for (const ObjectContact& entry : scene.at(id).contacts)
    if (entry.with.is_object()) touched.push_back(entry.with.object());
  for (const ObjectId other : touched) {
    // Held, invalid and fixed objects do not depend on friction.
    const ObjectState state = scene.at(other).state;
    if (state == ObjectState::Stable || state == ObjectState::Unsupported)
      rate_left_alone(transaction, other, rules, result);
  }
  return result;
}

}  // namespace trivet
