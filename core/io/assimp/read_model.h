// Formats that assimp reads.
#pragma once

#include "core/io/read_model.h"

namespace trivet {

/// FBX, Collada, 3DS and what else assimp knows. @throws Error (BadInput), std::bad_alloc.
Model read_assimp_model(const std::string& path, const ImportLimits& limits);

}  // namespace trivet
