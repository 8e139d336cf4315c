// Copies nodes of one glTF asset, with all their dependencies, into another.
#pragma once

#include "core/base/sentence.h"
#include "core/io/gltf/builder.h"

namespace trivet {

/// Everything but nodes is copied once, however often it is referenced; numbers are copied bit for
/// bit, unknown members unchanged; what is compressed stays so. Omitted and listed: skins and
/// joints, active deformations, extensions that may contain unknown references by index.
class GltfCopier {
 public:
  explicit GltfCopier(GltfBuilder& target) : m_target(target) {}

  /// Copies the node and its subtree. @return its index in the target.
  /// @throws Error (BadInput): an index out of range, nodes that do not form a tree.
  size_t copy_tree(const GltfDocument& source, int node);
  /// @throws Error (BadInput).
  size_t copy_mesh(const GltfDocument& source, const GltfJson& mesh);

  const std::map<std::string, Sentence>& left_out() const { return m_left_out; }

 private:
  using Key = std::tuple<const GltfDocument*, std::string_view, size_t>;
  template <class Copy>
  size_t once(const GltfDocument& source, const char* list, const GltfJson& index, Copy copy);

  size_t copy_node(const GltfDocument& source, int node, int depth);
  GltfJson primitive_of(const GltfDocument& source, GltfJson primitive);
  size_t copy_accessor(const GltfDocument& source, const GltfJson& index);
  size_t copy_view(const GltfDocument& source, const GltfJson& index);
  size_t copy_material(const GltfDocument& source, const GltfJson& index);
  size_t copy_texture(const GltfDocument& source, const GltfJson& index);
  void copy_image(const GltfDocument& source, GltfJson& texture);
  size_t copy_light(const GltfDocument& source, const GltfJson& index);
  void remap_textures(const GltfDocument& source, GltfJson& object, int depth);
  void leave_out(Sentence what);
  void keep_known_extensions(const GltfDocument& source, GltfJson& object);

  GltfBuilder& m_target;
  std::map<Key, size_t> m_copied;
  std::map<std::string, Sentence> m_left_out;  // by their English, which sorts them
  std::set<int> m_tree;                        // nodes of the tree being copied
};

/// Everything below some nodes of an asset, as an asset.
struct GltfPart {
  GltfDocument document;
  std::vector<int> roots;
  std::map<std::string, Sentence> left_out;  // by their English
};
/// @throws Error (BadInput): an index out of range, nodes that do not form a tree.
GltfPart copied_part(const GltfDocument& source, const std::vector<int>& roots);

}  // namespace trivet
