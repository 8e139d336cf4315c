// Transforms of glTF nodes: read as a reader in double sees them, and written back. Private: it
// shows the JSON library.
#pragma once

#include <optional>

#include "core/base/types.h"
#include "core/io/gltf/document.h"

namespace trivet {

/// The node's own transform, of the float32 values of its numbers. @throws Error (BadInput).
Affine local_transform(const GltfJson& node);

/// First b, then a.
Affine composed(const Affine& a, const Affine& b);
/// Nullopt if it is singular.
std::optional<Affine> inverse(const Affine& a);

/// Gives the node this transform, in the form that it has: a matrix, else translation, rotation and
/// scale, of which what does not change is left as it is.
/// @return false, and the node as it was: the transform has shear, or the scale is zero.
bool set_transform(const Affine& transform, GltfJson& node);

}  // namespace trivet
