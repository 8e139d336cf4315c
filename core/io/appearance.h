// What all writers need to know about a model's look, whoever made the model.
#pragma once

#include <utility>
#include <vector>

#include "core/io/model.h"
#include "core/io/normals.h"

namespace trivet {

/// Faces of one material, in the mesh's order.
struct MaterialFaces {
  Index material;
  std::vector<Index> faces;
};

/// Faces grouped by material, ascending, unused materials left out. Missing or invalid ids of
/// hand-made models count as material 0.
std::vector<MaterialFaces> faces_by_material(const Model& model);

/// The material, or the default one when the model has none.
Material material_or_default(const Model& model, Index material);

/// The model's corner normals if it has them, made unit, else smooth ones.
CornerNormals shading_normals(const Model& model);

}  // namespace trivet
