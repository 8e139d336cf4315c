// Numbers of glTF accessors, each checked against the buffer. Private: exposes the JSON library.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/io/gltf/document.h"

namespace trivet {

/// Values of an accessor, row after row; integers normalised as the accessor says.
struct GltfValues {
  int num_components = 0;
  std::vector<float> values;

  size_t size() const {
    return num_components == 0 ? 0 : values.size() / static_cast<size_t>(num_components);
  }
};

/// All component types, strides, sparse ones, and those without data, which are zero.
/// @throws Error (BadInput): no such accessor, unknown types, beyond the buffer.
GltfValues gltf_values(const GltfDocument& document, const GltfJson& accessor);

/// Ids of vertices. @throws Error (BadInput) as above, and for numbers that are no ids, or not
/// below `num_vertices`.
std::vector<std::uint32_t> gltf_indices(const GltfDocument& document, const GltfJson& accessor,
                                        size_t num_vertices);

/// Faces that a primitive draws, by its mode.
struct GltfFaces {
  std::uint64_t triangles = 0, lines = 0, points = 0;
  std::uint64_t left_over = 0;  // vertices that are too few for another triangle
};
/// From counts alone. @throws Error (BadInput): an unknown mode.
GltfFaces count_faces(const GltfJson& root, const GltfJson& primitive);

/// Ids of vertices of the triangles of a primitive, strips and fans taken apart; empty: points and
/// lines. @throws Error (BadInput) as above, and for ids that are not below `num_vertices`.
std::vector<std::array<std::uint32_t, 3>> gltf_triangles(const GltfDocument& document,
                                                         const GltfJson& primitive,
                                                         size_t num_vertices);

/// A number, a float, or `otherwise` where it is missing or not finite.
float number_or(const GltfJson& value, float otherwise);

}  // namespace trivet
