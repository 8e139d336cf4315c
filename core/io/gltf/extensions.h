// Extensions of glTF that Trivet knows. Private: exposes the JSON library.
#pragma once

#include <string>

#include "core/io/gltf/document.h"

namespace trivet::gltf {

inline constexpr const char *kDraco = "KHR_draco_mesh_compression",
                            *kInstancing = "EXT_mesh_gpu_instancing";

/// An extension that leaves indices of other lists alone, or whose indices GltfCopier follows.
bool is_known(const std::string& extension);

/// Files may not be read without these. @throws Error (BadInput) naming the file and what Trivet
/// does not have.
void check_required(const std::string& path, const GltfJson& root);

/// Compression of a buffer view (EXT_meshopt_compression, KHR_meshopt_compression); null: it is
/// plain.
const GltfJson& compression_of(const GltfJson& view);

/// A buffer without data, for readers that cannot decompress.
bool is_placeholder(const GltfJson& buffer);

/// Takes an extension away, and the object of extensions with its last one.
void drop_extension(GltfJson& object, const char* name);
void drop_compression(GltfJson& view);

}  // namespace trivet::gltf
