// Meshes made of closed shells that follow each other.
#pragma once

#include "core/mesh/mesh.h"

namespace trivet {

/// The same triangles; shells share no vertices any more, though they may have some in the same
/// place. A shell ends with the triangle that closes it. Colliders of a scene of another program
/// are such shells.
Mesh shells_apart(const Mesh& mesh);

}  // namespace trivet
