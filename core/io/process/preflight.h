// Pre-import checks that keep assimp from crashing, hanging or reporting vaguely on broken files.
#pragma once

#include <string>

#include "core/io/read_model.h"
#include "core/model/model.h"

struct aiScene;

namespace trivet {

/// Checks before the file is opened that it exists, is readable, not empty and within the limit.
/// @throws Error (BadInput) naming the file and the reason.
void check_file(const std::string& path, const ImportLimits& limits);

/// Checks between assimp's reading and its triangulation, which assumes that faces have corners
/// (else it aborts the program) and that indices are in range (else it reads out of bounds).
/// @throws Error (BadInput) naming the file, the mesh, the face and the index.
void check_faces(const std::string& path, const aiScene& scene);

}  // namespace trivet
