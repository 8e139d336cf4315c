// Checks that keep assimp from crashing, hanging or answering vaguely on broken files.
#pragma once

#include <string>

#include "core/io/model.h"

struct aiScene;

namespace trivet {

/// Before assimp opens the file: it is there, readable, not empty, not beyond the limit, and what
/// assimp 5.2 loops on forever or fills up silently is not in it (truncated PLY).
/// @throws Error (BadInput) naming the file and the reason.
void check_file(const std::string& path, const ImportLimits& limits);

/// Between assimp's reading and its triangulation, which takes for granted that faces have corners
/// (else it aborts the program) and that indices are in range (else it reads beyond its arrays).
/// @throws Error (BadInput) naming the file, the mesh, the face and the index.
void check_faces(const std::string& path, const aiScene& scene);

}  // namespace trivet
