#include "core/io/gltf/builder.h"

#include <algorithm>

#include "core/io/gltf/component_types.h"
#include "core/io/gltf/glb_container.h"

namespace trivet {
namespace {

// Constants of the glTF 2.0 specification.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

constexpr const char* kLights = "KHR_lights_punctual";

std::string_view bytes_of(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Names may come from files in any encoding; glTF requires UTF-8.
std::string dumped(const GltfJson& json) {
  return json.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
}

std::string without_separators(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
  return name.substr(0, 64);
}

}  // namespace

size_t GltfBuilder::add(const char* list, GltfJson item) {
  GltfJson& items = m_lists[list];
  items.push_back(std::move(item));
  return items.size() - 1;
}

size_t GltfBuilder::add_view(GltfJson view, std::string_view bytes, size_t remainder) {
  while (m_binary.size() % 4 != remainder) m_binary += '\0';
  view["buffer"] = 0;
  view["byteOffset"] = m_binary.size();
  view["byteLength"] = bytes.size();
  m_binary += bytes;
  return add("bufferViews", std::move(view));
}

size_t GltfBuilder::add_accessor(std::string_view bytes, size_t count, int target, int component,
                                 const char* type) {
  GltfJson view = {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 0}, {"target", target}};
  const size_t id = add_view(std::move(view), bytes);
  return add("accessors",
             {{"bufferView", id}, {"componentType", component}, {"count", count}, {"type", type}});
}

size_t GltfBuilder::add_floats(std::span<const float> values, int num_components) {
  constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return add_accessor(bytes_of(values), values.size() / static_cast<size_t>(num_components),
                      kArrayBuffer, gltf::kFloat, kTypes[num_components - 1]);
}

size_t GltfBuilder::add_positions(std::span<const float> values) {
  GltfJson lower = GltfJson::array(), upper = GltfJson::array();
  for (size_t axis = 0; axis < 3; ++axis) {
    float least = values[axis], greatest = values[axis];
    for (size_t i = axis; i < values.size(); i += 3)
      least = std::min(least, values[i]), greatest = std::max(greatest, values[i]);
    lower.push_back(least);
    upper.push_back(greatest);
  }
  const size_t id = add_floats(values, 3);
  m_lists["accessors"][id]["min"] = std::move(lower);
  m_lists["accessors"][id]["max"] = std::move(upper);
  return id;
}

size_t GltfBuilder::add_indices(const std::vector<std::uint32_t>& values) {
  return add_accessor({reinterpret_cast<const char*>(values.data()), 4 * values.size()},
                      values.size(), kElementArrayBuffer, gltf::kUnsignedInt, "SCALAR");
}

size_t GltfBuilder::add_image(GltfJson image, const SharedBytes& bytes) {
  const size_t hash = bytes ? std::hash<std::string>()(*bytes) : 0;
  const auto [begin, end] = m_image_of_hash.equal_range(hash);
  for (auto it = begin; bytes && it != end; ++it) {
    const SharedBytes& other = m_images[it->second];
    if (other && *other == *bytes) return it->second;
  }
  const size_t id = add("images", std::move(image));
  m_image_of_hash.emplace(hash, id);
  m_images.push_back(bytes);
  return id;
}

size_t GltfBuilder::add_light(GltfJson light) {
  use_extension(kLights, false);
  m_lights.push_back(std::move(light));
  return m_lights.size() - 1;
}

void GltfBuilder::use_extension(const std::string& name, bool required) {
  m_extensions[name] |= required;
}

void GltfBuilder::add_copyright(const std::string& text) { m_copyrights.insert(text); }

GltfDocument GltfBuilder::take(GltfJson scene) {
  GltfDocument out;
  out.json["asset"] = {{"version", "2.0"}, {"generator", "Trivet"}};
  std::string copyrights;
  for (const std::string& text : m_copyrights)
    copyrights += (copyrights.empty() ? "" : "; ") + text;
  if (!copyrights.empty()) out.json["asset"]["copyright"] = copyrights;
  GltfJson used = GltfJson::array(), required = GltfJson::array();
  for (const auto& [name, is_required] : m_extensions) {
    used.push_back(name);
    if (is_required) required.push_back(name);
  }
  if (!used.empty()) out.json["extensionsUsed"] = std::move(used);
  if (!required.empty()) out.json["extensionsRequired"] = std::move(required);
  out.json["scene"] = 0;
  out.json["scenes"] = GltfJson::array({std::move(scene)});
  // glTF forbids empty lists.
  for (const char* list : {"nodes", "cameras", "meshes", "materials", "textures", "samplers",
                           "images", "accessors", "bufferViews"})
    if (m_lists.contains(list)) out.json[list] = std::move(m_lists[list]);
  if (!m_lights.empty()) out.json["extensions"][kLights]["lights"] = std::move(m_lights);
  out.binary = std::move(m_binary);
  out.images = std::move(m_images);
  return out;
}

std::string glb_bytes(GltfDocument document) {
  std::string& binary = document.binary;
  for (size_t i = 0; i < document.images.size(); ++i) {
    const SharedBytes& bytes = document.images[i];
    if (!bytes) continue;
    binary.resize((binary.size() + 3) / 4 * 4);
    GltfJson& views = document.json["bufferViews"];
    document.json["images"][i]["bufferView"] = views.size();
    views.push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes->size()}});
    binary += *bytes;
  }
  if (!binary.empty())
    document.json["buffers"] = GltfJson::array({{{"byteLength", binary.size()}}});
  return pack_glb(dumped(document.json), binary);
}

std::string binary_name(const std::string& stem) { return stem + ".bin"; }

GltfFiles gltf_files(GltfDocument document, const std::string& stem) {
  GltfFiles out;
  std::set<std::string> taken;
  for (size_t i = 0; i < document.images.size(); ++i) {
    if (!document.images[i]) continue;
    GltfJson& image = document.json["images"][i];
    const std::string base = stem + "_" + without_separators(name_of(image));
    const std::string extension = member(image, "mimeType") == "image/jpeg"   ? ".jpg"
                                  : member(image, "mimeType") == "image/png"  ? ".png"
                                  : member(image, "mimeType") == "image/webp" ? ".webp"
                                                                              : ".img";
    std::string name = base + extension;
    for (int n = 2; !taken.insert(name).second; ++n)
      name = base + "_" + std::to_string(n) + extension;
    image["uri"] = name;
    out.images.emplace_back(name, document.images[i]);
  }
  out.binary = std::move(document.binary);
  out.binary_name = binary_name(stem);
  if (!out.binary.empty())
    document.json["buffers"] =
        GltfJson::array({{{"uri", out.binary_name}, {"byteLength", out.binary.size()}}});
  out.json = dumped(document.json);
  return out;
}

}  // namespace trivet
