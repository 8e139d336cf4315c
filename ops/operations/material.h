// MATERIAL: what an object is made of.
#pragma once

#include "core/scene/physics_material.h"
#include "ops/operations/move_options.h"

namespace trivet {

/// Sets the material; nothing moves, and no state changes. "material"
struct MaterialOperation {
  std::string object;
  PhysicsMaterial material;
};

template <>
const OperationTable& table<MaterialOperation>();
OperationResult apply(Transaction& transaction, const MaterialOperation& o, OperationRun& run);

}  // namespace trivet
