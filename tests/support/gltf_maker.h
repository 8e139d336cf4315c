// glTF files for tests, put together by hand: every number as the test wants it.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace trivet::test {

using Gltf = nlohmann::ordered_json;

/// A cube of 1 about the origin: corner i has x, y and z by its bits 0, 1 and 2.
inline constexpr int kCubeFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                          {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                          {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

class GltfMaker {
 public:
  Gltf json = {{"asset", {{"version", "2.0"}}}};
  std::string binary;

  /// Bytes of numbers; a stride puts them apart.
  template <class T>
  static std::string bytes_of(const std::vector<T>& values, size_t width = 0, size_t stride = 0) {
    std::string out;
    for (size_t i = 0; i < values.size(); ++i) {
      out.append(reinterpret_cast<const char*>(&values[i]), sizeof(T));
      if (stride && i % width == width - 1) out.append(stride - width * sizeof(T), '\x55');
    }
    return out;
  }

  size_t add(const char* list, Gltf item) {
    json[list].push_back(std::move(item));
    return json[list].size() - 1;
  }
  size_t add_view(const std::string& bytes, Gltf view = Gltf::object()) {
    binary.resize((binary.size() + 3) / 4 * 4);
    view.update({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary += bytes;
    return add("bufferViews", std::move(view));
  }
  size_t add_accessor(const std::string& bytes, int component, size_t count, const char* type,
                      const Gltf& more = Gltf::object()) {
    Gltf accessor = {{"bufferView", add_view(bytes)},
                     {"componentType", component},
                     {"count", count},
                     {"type", type}};
    accessor.update(more);
    return add("accessors", std::move(accessor));
  }

  static std::vector<float> cube_corners(float half = 0.5f) {
    std::vector<float> out;
    for (int i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis) out.push_back((i >> axis & 1) ? half : -half);
    return out;
  }
  size_t add_cube_positions() { return add_accessor(bytes_of(cube_corners()), 5126, 8, "VEC3"); }
  size_t add_cube_indices() {
    std::vector<std::uint16_t> out;
    for (const auto& face : kCubeFaces)
      for (const int v : face) out.push_back(static_cast<std::uint16_t>(v));
    return add_accessor(bytes_of(out), 5123, 36, "SCALAR");
  }
  size_t add_mesh(size_t positions, size_t indices) {
    return add("meshes", {{"primitives",
                           {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}});
  }
  /// A cube of side 1, in the float32 that most files have.
  size_t add_cube() {
    const size_t positions = add_cube_positions();
    return add_mesh(positions, add_cube_indices());
  }
  Gltf& primitive() { return json["meshes"].back()["primitives"].back(); }

  /// All nodes that are no children are shown.
  void show_nodes(const Gltf& nodes) {
    json["nodes"] = nodes;
    std::vector<bool> is_child(nodes.size(), false);
    for (const Gltf& node : nodes)
      if (node.contains("children"))
        for (const Gltf& child : node["children"]) is_child[child.get<size_t>()] = true;
    Gltf roots = Gltf::array();
    for (size_t i = 0; i < nodes.size(); ++i)
      if (!is_child[i]) roots.push_back(i);
    json["scenes"] = Gltf::array({{{"nodes", roots}}});
    json["scene"] = 0;
  }

  static std::string chunk(const char* type, const std::string& bytes) {
    const auto length = static_cast<std::uint32_t>(bytes.size());
    return std::string(reinterpret_cast<const char*>(&length), 4) + std::string(type, 4) + bytes;
  }
  static std::string container(const std::string& chunks, std::uint32_t version = 2) {
    const auto total = static_cast<std::uint32_t>(12 + chunks.size());
    return "glTF" + std::string(reinterpret_cast<const char*>(&version), 4) +
           std::string(reinterpret_cast<const char*>(&total), 4) + chunks;
  }
  Gltf with_buffer(Gltf buffer = Gltf::object()) const {
    Gltf out = json;
    buffer["byteLength"] = binary.size();
    if (!out.contains("buffers")) out["buffers"] = Gltf::array();
    out["buffers"].insert(out["buffers"].begin(), std::move(buffer));
    return out;
  }
  std::string glb() const {
    std::string text = with_buffer().dump(), data = binary;
    text.append((4 - text.size() % 4) % 4, ' ');
    data.append((4 - data.size() % 4) % 4, '\0');
    return container(chunk("JSON", text) + chunk("BIN\0", data));
  }
  std::string text(const std::string& uri) const { return with_buffer({{"uri", uri}}).dump(); }
};

}  // namespace trivet::test
