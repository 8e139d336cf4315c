// A glTF 2.0 asset in memory: its JSON, one buffer, and its encoded images. Private: exposes the
// JSON library, which users of the headers need not have.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

using GltfJson = nlohmann::ordered_json;
using SharedBytes = std::shared_ptr<const std::string>;

/// Buffer 0 is `binary`; images have neither uri nor bufferView, their bytes are in `images`. Views
/// compressed by an extension have the range of their compressed bytes.
struct GltfDocument {
  GltfJson json = GltfJson::object();
  std::string binary;
  std::vector<SharedBytes> images;  // parallel to json["images"]; null: the file is missing
};

/// Parses untrusted JSON. @throws Error (BadInput) naming the file: malformed, or nested so deeply
/// that recursion could exhaust the stack.
GltfJson parse_gltf_json(const std::string& path, const std::string& text);

/// The JSON of a .glb or .gltf. @throws Error (BadInput) naming the file.
std::string read_gltf_text(const std::string& path);

/// Reads a .glb or .gltf with its buffers and images into the form above. Unavailable images are
/// null. @throws Error (BadInput) naming the file and the missing or out-of-range item.
GltfDocument read_gltf_document(const std::string& path, const ImportLimits& limits);
/// The same of the file's JSON, once that is parsed.
GltfDocument resolved_gltf(const std::string& path, GltfJson json, const ImportLimits& limits);

/// A relative URI as a path.
std::string decoded_uri(const std::string& uri);

/// A member of an object; null if absent. Returned by reference, as members may be large.
const GltfJson& member(const GltfJson& object, const char* key);
/// An element of a top-level list. @throws Error (BadInput): no such list, or out of range.
const GltfJson& element(const GltfJson& root, const char* list, const GltfJson& index);
/// "" if it has none.
std::string name_of(const GltfJson& object);
/// @throws Error (BadInput) if it is not an index.
size_t index_from(const GltfJson& value);
/// Root nodes of the default scene. @throws Error (BadInput).
std::vector<int> scene_roots(const GltfJson& root);

/// "image/png", "image/jpeg" or "image/webp", by the first bytes; "": none that is read.
std::string image_type(const std::string& bytes);

/// Deeper trees of nodes are refused: those who walk them recurse.
inline constexpr int kMaxNodeDepth = 500;

}  // namespace trivet
