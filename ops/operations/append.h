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
  std::string object;        // its name
  std::string model;         // path as the scene's models have theirs
  double scale = 1;          // metres per unit of the file
  std::optional<UpAxis> up;  // nullopt: as the model's format says, else z
  bool fixed = false;
  std::shared_ptr<const Model> model_data;  // filled by load_model(); not written down
  std::shared_ptr<const Shape> shape;
  Tessellation tessellation = {};  // of a model with curved surfaces
  std::optional<PhysicsMaterial> material =
      {};  // nullopt: a layout's default, else PhysicsMaterial
};

/// After the name of a model, where its fineness is asked for.
inline constexpr const char* kNoCurvedSurfaces =
    " has no curved surfaces; accepted: with models in STEP, IGES or BREP (.step .stp .iges .igs "
    ".brep .brp)";

template <>
const OperationTable& table<AppendOperation>();
OperationResult apply(Transaction& transaction, const AppendOperation& o, OperationRun& run);

}  // namespace trivet
