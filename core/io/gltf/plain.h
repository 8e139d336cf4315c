// glTF with nothing that only some readers know. Private: exposes the JSON library.
#pragma once

#include "core/io/gltf/document.h"

namespace trivet {

/// The same asset without compression (meshoptimizer, Draco), instances by extension, sparse
/// accessors, and attributes as integers where core glTF has floats: positions, normals, tangents
/// and texture coordinates are then float32, instances nodes of their own. What is plain stays as
/// it is, bit for bit. Rotations have the length 1; a note counts the others.
/// @throws Error (BadInput): data that cannot be decoded, or that is not there.
GltfDocument plain_gltf(GltfDocument document, const ImportLimits& limits,
                        std::vector<Sentence>& notes);

/// @throws Error (BadInput) naming what is not plain.
void check_plain(const GltfJson& root);

}  // namespace trivet
