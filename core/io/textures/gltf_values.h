// Numbers of glTF accessors. Private: exposes the JSON library.
#pragma once

#include "core/io/gltf/document.h"

namespace trivet {

/// Values of an accessor, row after row; integers normalised as the accessor says.
struct GltfValues {
  int num_components = 0;
  std::vector<float> values;

  size_t size() const { return num_components == 0 ? 0 : values.size() / num_components; }
};

/// @throws Error (BadInput): no such accessor, sparse, types that are unknown, or beyond the
/// buffer.
GltfValues gltf_values(const GltfDocument& document, const GltfJson& accessor);

/// Ids of vertices of the triangles of a primitive, strips and fans taken apart; empty: points and
/// lines. @throws Error (BadInput) as above, and for ids that are not below `num_vertices`.
std::vector<std::array<std::uint32_t, 3>> gltf_triangles(const GltfDocument& document,
                                                         const GltfJson& primitive,
                                                         size_t num_vertices);

/// A number, a float, or `otherwise` where it is missing or not finite.
float number_or(const GltfJson& value, float otherwise);

}  // namespace trivet
