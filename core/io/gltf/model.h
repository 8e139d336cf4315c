// Models from glTF 2.0, text or binary.
#pragma once

#include <optional>
#include <string>

#include "core/io/read_model.h"

namespace trivet {

/// @return nullopt: glTF 1, another format.
/// @throws Error (BadInput) naming the file and what is wrong.
std::optional<Model> read_gltf_model(const std::string& path, const ImportLimits& limits);

}  // namespace trivet
