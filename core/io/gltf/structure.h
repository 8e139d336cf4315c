// Structure that all readers of glTF rely on. Private: exposes the JSON library.
#pragma once

#include "core/io/gltf/document.h"

namespace trivet {

/// Lists are arrays of objects, primitives have attributes, children and extensions are where they
/// belong. @throws Error (BadInput) naming the place, what is there and what is accepted.
void check_structure(const GltfJson& root);

}  // namespace trivet
