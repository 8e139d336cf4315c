#include "core/io/gltf/plain.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/io/gltf/component_types.h"
#include "core/io/gltf/compressed.h"
#include "core/io/gltf/extensions.h"
#include "core/io/gltf/instances.h"
#include "core/io/gltf/values.h"

namespace trivet {
namespace {

// Each becomes a node of half a kilobyte.
constexpr size_t kMostInstances = 1'000'000;

bool begins(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

bool is_float(const GltfJson& accessor) {
  return member(accessor, "componentType") == gltf::kFloat;
}

// As core glTF has it: other components need KHR_mesh_quantization.
bool has_core_type(const std::string& attribute, const GltfJson& accessor) {
  if (is_float(accessor)) return true;
  if (begins(attribute, "TEXCOORD_")) {
    const GltfJson& component = member(accessor, "componentType");
    return member(accessor, "normalized") == true &&
           (component == gltf::kUnsignedByte || component == gltf::kUnsignedShort);
  }
  return attribute != "POSITION" && attribute != "NORMAL" && attribute != "TANGENT";
}

bool has_plain_data(const GltfJson& accessor) {
  return accessor.contains("bufferView") && !accessor.contains("sparse");
}

class Plainer {
 public:
  Plainer(GltfDocument& document, const ImportLimits& limits)
      : m_document(document), m_json(document.json), m_limits(limits) {}

  void run(std::vector<Sentence>& notes) {
    decode_views();
    // Before anything refers to what is in the object: another member would move it.
    for (const char* const list : {"bufferViews", "accessors", "nodes"})
      if (!m_json.contains(list)) m_json[list] = GltfJson::array();
    if (m_json.contains("meshes"))
      for (size_t i = 0; i < m_json["meshes"].size(); ++i) make_plain(i);
    expand_instances();
    make_rotations_unit(notes);
  }

 private:
  void make_rotations_unit(std::vector<Sentence>& notes) {
    size_t count = 0;
    for (GltfJson& node : m_json["nodes"]) count += make_rotation_unit(node);
    if (count > 0) notes.push_back(say("rotations of nodes brought to length 1: %1", count));
  }

  void decode_views() {
    if (!m_json.contains("bufferViews")) return;
    for (GltfJson& view : m_json["bufferViews"]) {
      const GltfJson& compression = gltf::compression_of(view);
      if (compression.is_null()) continue;
      const std::string_view from =
          std::string_view(m_document.binary)
              .substr(view["byteOffset"].get<size_t>(), view["byteLength"].get<size_t>());
      const std::string bytes = gltf::decoded_meshopt(from, compression);
      if (member(compression, "mode") == "ATTRIBUTES")
        view["byteStride"] = member(compression, "byteStride");
      gltf::drop_compression(view);
      view["byteOffset"] = append(bytes);
      view["byteLength"] = bytes.size();
    }
  }

  // @return where in the buffer.
  size_t append(std::string_view bytes) {
    std::string& binary = m_document.binary;
    binary.resize((binary.size() + 3) / 4 * 4);
    const size_t at = binary.size();
    if (bytes.size() > m_limits.max_file_bytes - std::min(m_limits.max_file_bytes, at))
      bad_input("the buffers exceed the limit");
    binary += bytes;
    return at;
  }

  size_t add_to(const char* list, GltfJson item) {
    m_json[list].push_back(std::move(item));
    return m_json[list].size() - 1;
  }

  size_t add_accessor(std::string_view bytes, size_t count, int component, const char* type) {
    const size_t at = append(bytes);
    const size_t view =
        add_to("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes.size()}});
    return add_to(
        "accessors",
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  }

  size_t add_floats(const GltfValues& values, bool bounds) {
    constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::string_view bytes{reinterpret_cast<const char*>(values.values.data()),
                                 values.values.size() * sizeof(float)};
    const size_t id =
        add_accessor(bytes, values.size(), gltf::kFloat, kTypes[values.num_components - 1]);
    if (bounds && values.size() > 0) add_bounds(values, m_json["accessors"][id]);
    return id;
  }

  static void add_bounds(const GltfValues& values, GltfJson& accessor) {
    const auto width = static_cast<size_t>(values.num_components);
    for (size_t c = 0; c < width; ++c) {
      float least = values.values[c], greatest = least;
      for (size_t i = c; i < values.values.size(); i += width)
        least = std::min(least, values.values[i]), greatest = std::max(greatest, values.values[i]);
      accessor["min"].push_back(least);
      accessor["max"].push_back(greatest);
    }
  }

  size_t add_indices(const std::vector<std::uint32_t>& ids) {
    return add_accessor({reinterpret_cast<const char*>(ids.data()), 4 * ids.size()}, ids.size(),
                        gltf::kUnsignedInt, "SCALAR");
  }

  void make_plain(size_t mesh) {
    GltfJson& primitives = m_json["meshes"][mesh]["primitives"];
    for (size_t i = 0; i < primitives.size(); ++i) try {
        make_plain_primitive(primitives[i]);
      } catch (const Error& e) {
        const std::string name = printable(name_of(m_json["meshes"][mesh]), 100);
        bad_input("mesh '%1', primitive %2: %3",
                  (name.empty() ? "number " + std::to_string(mesh) : name), i, e.what());
      }
  }

  void make_plain_primitive(GltfJson& primitive) {
    if (!member(member(primitive, "extensions"), gltf::kDraco).is_null()) decode(primitive);
    if (primitive.contains("attributes")) make_plain(primitive["attributes"]);
    if (primitive.contains("targets"))
      for (GltfJson& target : primitive["targets"]) make_plain(target);
    if (primitive.contains("indices")) make_plain_indices(primitive["indices"]);
  }

  void make_plain(GltfJson& attributes) {
    for (auto& [name, id] : attributes.items()) {
      const GltfJson& accessor = element(m_json, "accessors", id);
      if (has_plain_data(accessor) && has_core_type(name, accessor)) continue;
      const auto [found, is_new] = m_floats.try_emplace(index_from(id), 0);
      if (is_new) found->second = add_floats(gltf_values(m_document, id), name == "POSITION");
      id = found->second;
    }
  }

  void make_plain_indices(GltfJson& id) {
    const GltfJson& accessor = element(m_json, "accessors", id);
    if (has_plain_data(accessor)) return;
    const auto [found, is_new] = m_indices.try_emplace(index_from(id), 0);
    if (is_new) found->second = add_indices(gltf_indices(m_document, id, SIZE_MAX));
    id = found->second;
  }

  gltf::DracoAttribute wanted(const GltfJson& primitive, const std::string& name,
                              const GltfJson& id) const {
    gltf::DracoAttribute out;
    out.id = static_cast<std::uint32_t>(index_from(id));
    const GltfJson& accessor = element(m_json, "accessors", primitive["attributes"][name]);
    const GltfJson& component = member(accessor, "componentType");
    if (member(accessor, "normalized") == true)
      out.scale = component == gltf::kByte            ? 127.0f
                  : component == gltf::kUnsignedByte  ? 255.0f
                  : component == gltf::kShort         ? 32767.0f
                  : component == gltf::kUnsignedShort ? 65535.0f
                                                      : 0.0f;
    return out;
  }

  void decode(GltfJson& primitive) {
    const GltfJson draco = primitive["extensions"][gltf::kDraco];
    const GltfJson& view = element(m_json, "bufferViews", member(draco, "bufferView"));
    std::vector<gltf::DracoAttribute> attributes;
    for (const auto& [name, id] : member(draco, "attributes").items())
      if (primitive["attributes"].contains(name)) attributes.push_back(wanted(primitive, name, id));
    const gltf::DracoMesh mesh = gltf::decoded_draco(
        std::string_view(m_document.binary)
            .substr(view["byteOffset"].get<size_t>(), view["byteLength"].get<size_t>()),
        attributes);
    GltfJson found = GltfJson::object();
    for (const auto& [name, id] : member(draco, "attributes").items())
      if (const auto it = mesh.attributes.find(static_cast<std::uint32_t>(index_from(id)));
          it != mesh.attributes.end())
        found[name] = add_floats(it->second, name == "POSITION");
    primitive["attributes"] = std::move(found);
    primitive["indices"] = add_indices(mesh.indices);
    primitive.erase("mode");
    primitive.erase("targets");
    gltf::drop_extension(primitive, gltf::kDraco);
  }

  void expand_instances() {
    const size_t num_nodes = m_json["nodes"].size();
    for (size_t i = 0; i < num_nodes; ++i)
      if (member(member(m_json["nodes"][i], "extensions"), gltf::kInstancing).is_object())
        expand_node(i);
  }

  // One node for each instance, before the other children.
  void expand_node(size_t node) {
    const GltfJson attributes = member(
        member(member(m_json["nodes"][node], "extensions"), gltf::kInstancing), "attributes");
    gltf::drop_extension(m_json["nodes"][node], gltf::kInstancing);
    if (!m_json["nodes"][node].contains("mesh")) return;
    const GltfJson mesh = m_json["nodes"][node]["mesh"];
    m_json["nodes"][node].erase("mesh");
    std::vector<GltfJson> instances = instances_of(attributes);
    m_num_instances += instances.size();
    if (m_num_instances > kMostInstances)
      bad_input("has more than %1 instances, the limit", kMostInstances);
    GltfJson children = GltfJson::array();
    for (GltfJson& instance : instances) {
      instance["mesh"] = mesh;
      children.push_back(add_to("nodes", std::move(instance)));
    }
    for (const GltfJson& child : member(m_json["nodes"][node], "children"))
      children.push_back(child);
    if (!children.empty()) m_json["nodes"][node]["children"] = std::move(children);
  }

  std::vector<GltfJson> instances_of(const GltfJson& attributes) const {
    std::vector<GltfJson> out;
    constexpr std::pair<const char*, const char*> kMembers[] = {
        {"TRANSLATION", "translation"}, {"ROTATION", "rotation"}, {"SCALE", "scale"}};
    for (const auto& [name, key] : kMembers) {
      const GltfJson& id = member(attributes, name);
      if (id.is_null()) continue;
      const GltfValues values = gltf_values(m_document, id);
      if (values.num_components != (std::string(key) == "rotation" ? 4 : 3))
        bad_input("instances have a %1 of %2 components", name, values.num_components);
      if (out.empty()) out.resize(std::min(values.size(), kMostInstances + 1));
      if (out.size() != std::min(values.size(), kMostInstances + 1))
        bad_input("instances have %1 values of %2 for %3 instances", values.size(), name,
                  out.size());
      for (size_t i = 0; i < out.size(); ++i)
        for (size_t c = 0; c < static_cast<size_t>(values.num_components); ++c) {
          const float value = values.values[i * static_cast<size_t>(values.num_components) + c];
          if (!std::isfinite(value)) bad_input("instance %1 has a %2 that is not finite", i, name);
          out[i][key].push_back(value);
        }
      // Integers have the length 1 roughly.
      if (std::string(key) == "rotation" && !is_float(element(m_json, "accessors", id)))
        for (GltfJson& instance : out) make_rotation_unit(instance);
    }
    return out;
  }

  GltfDocument& m_document;
  GltfJson& m_json;
  const ImportLimits& m_limits;
  std::map<size_t, size_t> m_floats, m_indices;  // accessors of the file: what stands for them
  size_t m_num_instances = 0;
};

}  // namespace

GltfDocument plain_gltf(GltfDocument document, const ImportLimits& limits,
                        std::vector<Sentence>& notes) {
  Plainer(document, limits).run(notes);
  return document;
}

void check_plain(const GltfJson& root) {
  for (const GltfJson& view : member(root, "bufferViews"))
    if (!gltf::compression_of(view).is_null()) bad_input("a buffer view that is compressed");
  for (const GltfJson& node : member(root, "nodes"))
    if (!member(member(node, "extensions"), gltf::kInstancing).is_null())
      bad_input("instances by extension");
  for (GltfJson node : member(root, "nodes"))
    if (make_rotation_unit(node)) bad_input("rotations whose length is not 1");
  for (const GltfJson& mesh : member(root, "meshes"))
    for (const GltfJson& primitive : member(mesh, "primitives")) {
      if (!member(member(primitive, "extensions"), gltf::kDraco).is_null())
        bad_input("a mesh that is compressed by Draco");
      const GltfJson& position = member(member(primitive, "attributes"), "POSITION");
      if (position.is_null()) continue;
      const GltfJson& accessor = element(root, "accessors", position);
      if (!is_float(accessor) || !has_plain_data(accessor))
        bad_input("positions that are not plain float32");
    }
}

}  // namespace trivet
