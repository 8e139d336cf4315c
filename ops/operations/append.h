// APPEND: a new object of a model.
#pragma once

#include <memory>

#include "core/index/shape.h"
#include "core/model/model.h"
#include "core/model/tessellation.h"
#include "core/scene/physics_material.h"
#include "ops/operations/move_options.h"

namespace trivet {

/// A new object, not placed until it is put. Refused: the name is taken or invalid; the model was
/// not loaded. "append"
struct AppendOperation {
  std::string object;           // its name
  std::string model;            // path as the scene's models have theirs
  std::optional<double> scale;  // metres per unit of the file; nullopt: as it states, else 1
  std::optional<UpAxis> up;     // nullopt: as the model's format says, else z
  bool fixed = false;
  std::shared_ptr<const Model> model_data;  // filled by load_model(); not written down
  std::shared_ptr<const Shape> shape;
  Tessellation tessellation = {};  // of a model with curved surfaces
  std::optional<PhysicsMaterial> material =
      {};  // nullopt: a layout's default, else PhysicsMaterial
};

/// Said of a model whose fineness is asked for.
Sentence no_curved_surfaces(const std::string& model);

template <>
const OperationTable& table<AppendOperation>();
OperationResult apply(Transaction& transaction, const AppendOperation& o, OperationRun& run);

}  // namespace trivet
