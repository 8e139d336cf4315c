// Assembles a glTF asset list by list. Private: exposes the JSON library.
#pragma once

#include <map>
#include <set>
#include <span>
#include <unordered_map>

#include "core/io/gltf/document.h"

namespace trivet {

class GltfBuilder {
 public:
  /// Room for so many bytes of buffer views.
  void reserve(size_t bytes) { m_binary.reserve(bytes); }

  /// Appends to a top-level list. @return its index there.
  size_t add(const char* list, GltfJson item);

  /// Float vectors of 1 to 4 components. @param target  of the buffer view; 0: none.
  size_t add_floats(std::span<const float> values, int num_components);
  /// The same with `min` and `max`, which glTF requires for positions.
  size_t add_positions(std::span<const float> values);
  size_t add_indices(const std::vector<std::uint32_t>& values);
  /// A buffer view of these bytes, at an offset congruent to `remainder` modulo 4.
  size_t add_view(GltfJson view, std::string_view bytes, size_t remainder = 0);

  /// Stores equal images once.
  size_t add_image(GltfJson image, const SharedBytes& bytes);
  /// A light of KHR_lights_punctual.
  size_t add_light(GltfJson light);
  void use_extension(const std::string& name, bool required);
  void add_copyright(const std::string& text);

  /// The asset with one scene, members in the order of the specification.
  GltfDocument take(GltfJson scene);

 private:
  size_t add_accessor(std::string_view bytes, size_t count, int target, int component,
                      const char* type);

  GltfJson m_lists = GltfJson::object();
  GltfJson m_lights = GltfJson::array();
  std::string m_binary;
  std::vector<SharedBytes> m_images;
  std::unordered_multimap<size_t, size_t> m_image_of_hash;
  std::map<std::string, bool> m_extensions;  // required?
  std::set<std::string> m_copyrights;
};

/// One file. @throws Error (BadInput): more than 4 GiB.
std::string glb_bytes(GltfDocument document);

/// A JSON file and the companion files it names.
struct GltfFiles {
  std::string json, binary_name;
  std::string binary;                                       // empty: none
  std::vector<std::pair<std::string, SharedBytes>> images;  // name, content
};
/// @param stem  common stem of all file names.
GltfFiles gltf_files(GltfDocument document, const std::string& stem);
/// File name of the buffer.
std::string binary_name(const std::string& stem);

}  // namespace trivet
