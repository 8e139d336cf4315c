// Materials, up axis and unit of an assimp scene.
#pragma once

#include <string>
#include <string_view>

#include "core/model/model.h"

struct aiScene;

namespace trivet {

/// Fills materials of `model`; at least one, in the scene's order. Reads model.format.
void read_materials(const aiScene& scene, Model& model);

/// Fills up, up_from_format and metres_per_unit of `model`. Reads model.format. Takes
/// the unit of Collada out of the root, so that coordinates are those of the file.
/// @param head  the first bytes of the file, text as UTF-8.
void read_frame(aiScene& scene, std::string_view head, Model& model);

}  // namespace trivet
