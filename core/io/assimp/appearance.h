// Materials, up axis and unit of an assimp scene.
#pragma once

#include <string>

#include "core/model/model.h"

struct aiScene;

namespace trivet {

/// Fills materials of `model`; at least one, in the scene's order. Reads model.format.
void read_materials(const aiScene& scene, Model& model);

/// Fills up, up_from_format and metres_per_unit of `model`. Reads model.format.
void read_frame(const aiScene& scene, Model& model);

}  // namespace trivet
