// A glTF 2.0 asset in memory: its JSON, one buffer, and its images as they are encoded. Private: it
// shows the JSON library, which users need not have.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/model.h"

namespace trivet {

using GltfJson = nlohmann::ordered_json;
using SharedBytes = std::shared_ptr<const std::string>;

/// Buffer 0 is `binary`; images hold neither uri nor bufferView, their bytes lie beside them.
struct GltfDocument {
  GltfJson json = GltfJson::object();
  std::string binary;
  std::vector<SharedBytes> images;  // parallel to json["images"]; null: the file has gone
};

/// Parses what may be hostile. @throws Error (BadInput) naming the file: broken, or nested so deep
/// that recursion over it could exhaust the stack.
GltfJson parse_gltf_json(const std::string& path, const std::string& text);

/// The JSON of a .glb or .gltf. @throws Error (BadInput) naming the file.
std::string read_gltf_text(const std::string& path);

/// A .glb or .gltf with its buffers and images, in the form above. Images that cannot be had are
/// null. @throws Error (BadInput) naming the file and what is missing or out of range.
GltfDocument read_gltf_document(const std::string& path, const ImportLimits& limits);

/// A relative URI as a path.
std::string decoded_uri(const std::string& uri);

/// A member of an object; null where there is none. A reference, as members may be large.
const GltfJson& member(const GltfJson& object, const char* key);
/// An element of a top-level list. @throws Error (BadInput): no such list, or out of range.
const GltfJson& element(const GltfJson& root, const char* list, const GltfJson& index);
/// "" when it has none.
std::string name_of(const GltfJson& object);
/// @throws Error (BadInput) when it is no index.
size_t index_from(const GltfJson& value);
/// The roots of the scene that is shown. @throws Error (BadInput).
std::vector<int> scene_roots(const GltfJson& root);

/// "image/png" or "image/jpeg", by the first bytes; "": glTF has no place for it.
std::string image_type(const std::string& bytes);

}  // namespace trivet
