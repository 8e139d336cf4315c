// Appearance of models in formats other than glTF.
#pragma once

#include "core/io/look.h"
#include "core/io/read_model.h"

struct aiScene;

namespace trivet {

/// Reads path, format, materials and mesh of `model`; adds notes. Null if geometry, normals and
/// materials describe the model completely: one node without a transform, no texture coordinates,
/// no vertex colours.
std::shared_ptr<const Appearance> appearance_of_assimp(const aiScene& scene,
                                                       const ImportLimits& limits, Model& model);

}  // namespace trivet
