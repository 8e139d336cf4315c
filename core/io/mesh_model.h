// Models of meshes that no file has.
#pragma once

#include "core/model/model.h"

namespace trivet {

/// A model of one grey material, its path empty, z up. Its shape is make_shape(model.mesh)
/// (core/index/shape.h). Scene files keep its doubles.
/// @param mesh  as weld() gives it. @throws Error (BadInput) when it has no triangle.
Model model_of_mesh(Mesh mesh);

}  // namespace trivet
