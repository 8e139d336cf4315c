// Compressed parts of glTF, decoded by libraries that are optional. Private.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/gltf/values.h"

namespace trivet::gltf {

/// Bytes of a view that meshoptimizer has compressed. @param compression  of the view: count,
/// byteStride, mode, filter. @throws Error (BadInput): damaged, or this build has no decoder.
std::string decoded_meshopt(std::string_view bytes, const GltfJson& compression);

/// A mesh of Draco: triangles, and attributes by their numbers in it.
struct DracoMesh {
  std::vector<std::uint32_t> indices;
  std::map<std::uint32_t, GltfValues> attributes;
};
/// An attribute that is wanted, and how its integers are scaled.
struct DracoAttribute {
  std::uint32_t id = 0;
  float scale = 0;  // integers are divided by it and at least -1; 0: they stay
};
/// @throws Error (BadInput): damaged, or this build has no decoder.
DracoMesh decoded_draco(std::string_view bytes, const std::vector<DracoAttribute>& wanted);

}  // namespace trivet::gltf
