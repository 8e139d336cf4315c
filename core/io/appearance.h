// Appearance of a model as all writers need it.
#pragma once

#include <utility>
#include <vector>

#include "core/io/mesh/normals.h"
#include "core/model/model.h"

namespace trivet {

/// Faces of one material, in the mesh's order.
struct MaterialFaces {
  Index material;
  std::vector<Index> faces;
};

/// Groups faces by material, ascending, without unused materials. Missing or invalid ids count as
/// material 0.
std::vector<MaterialFaces> faces_by_material(const Model& model);

/// The material, or the default one when the model has none.
Material material_or_default(const Model& model, Index material);

/// The model's corner normals, normalised, if it has them; else smooth ones.
CornerNormals shading_normals(const Model& model);

}  // namespace trivet
