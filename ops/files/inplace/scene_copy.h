// A glTF scene written as it was but for its JSON. Private: it shows the JSON library.
#pragma once

#include <string>

#include "core/io/gltf/document.h"

namespace trivet {

/// Writes the scene of the file `from` with `json` for its JSON: other chunks byte for byte. Files
/// that `original`, its JSON as read, names go along to another folder.
/// @throws Error: BadInput for another kind of file than the scene's, or files outside its folder;
///   Environment.
void write_scene_copy(const std::string& from, const GltfJson& original, const GltfJson& json,
                      const std::string& to);

}  // namespace trivet
