// Pre-import checks that keep assimp from crashing, hanging or reporting vaguely on broken files.
#pragma once

#include <string>

#include "core/io/read_model.h"
#include "core/model/model.h"

struct aiScene;

namespace trivet {

/// Checks before assimp opens the file that it exists, is readable, not empty, within the limit,
/// and free of the truncated PLY on which assimp 5.2 loops forever or invents data.
/// @throws Error (BadInput) naming the file and the reason.
void check_file(const std::string& path, const ImportLimits& limits);

/// Checks between assimp's reading and its triangulation, which assumes that faces have corners
/// (else it aborts the program) and that indices are in range (else it reads out of bounds).
/// @throws Error (BadInput) naming the file, the mesh, the face and the index.
void check_faces(const std::string& path, const aiScene& scene);

}  // namespace trivet
