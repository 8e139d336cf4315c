#include "core/io/gltf/copy.h"

#include <algorithm>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/io/gltf/extensions.h"

namespace trivet {
namespace {

bool is_texture_key(const std::string& key) {
  constexpr std::string_view end = "Texture";
  return key.size() >= end.size() && key.compare(key.size() - end.size(), end.size(), end) == 0;
}

bool is_required(const GltfDocument& source, const std::string& extension) {
  const GltfJson& list = member(source.json, "extensionsRequired");
  return list.is_array() && std::find(list.begin(), list.end(), extension) != list.end();
}

const GltfJson& lights_of(const GltfDocument& source) {
  return member(member(source.json, "extensions"), "KHR_lights_punctual");
}

}  // namespace

template <class Copy>
size_t GltfCopier::once(const GltfDocument& source, const char* list, const GltfJson& index,
                        Copy copy) {
  const Key key{&source, list, index_from(index)};
  if (const auto found = m_copied.find(key); found != m_copied.end()) return found->second;
  GltfJson item = element(source.json, list, index);
  keep_known_extensions(source, item);
  const size_t id = copy(std::move(item));
  m_copied.emplace(key, id);
  return id;
}

void GltfCopier::leave_out(Sentence what) { m_left_out.emplace(in_english(what), std::move(what)); }

void GltfCopier::keep_known_extensions(const GltfDocument& source, GltfJson& object) {
  const auto found = object.find("extensions");
  if (found == object.end()) return;
  GltfJson kept = GltfJson::object();
  for (const auto& [name, content] : found->items()) {
    if (gltf::is_known(name)) {
      m_target.use_extension(name, is_required(source, name));
      kept[name] = content;
    } else {
      leave_out(say("the extension %1", name.substr(0, 100)));
    }
  }
  if (kept.empty())
    object.erase("extensions");
  else
    *found = std::move(kept);
}

GltfPart copied_part(const GltfDocument& source, const std::vector<int>& roots) {
  GltfBuilder builder;
  GltfCopier copier(builder);
  GltfPart out;
  for (const int root : roots)
    out.roots.push_back(static_cast<int>(copier.copy_tree(source, root)));
  out.document = builder.take(GltfJson::object());
  out.left_out = copier.left_out();
  return out;
}

size_t GltfCopier::copy_tree(const GltfDocument& source, int node) {
  m_tree.clear();
  if (const GltfJson& text = member(member(source.json, "asset"), "copyright"); text.is_string())
    m_target.add_copyright(text.get<std::string>());
  return copy_node(source, node, 0);
}

size_t GltfCopier::copy_node(const GltfDocument& source, int node, int depth) {
  if (depth > kMaxNodeDepth || !m_tree.insert(node).second)
    bad_input("its nodes do not form a tree, or nest too deeply");
  GltfJson out = element(source.json, "nodes", GltfJson(static_cast<unsigned>(node)));
  keep_known_extensions(source, out);
  if (out.contains("mesh")) out["mesh"] = copy_mesh(source, out["mesh"]);
  if (out.contains("camera"))
    out["camera"] = once(source, "cameras", out["camera"], [&](GltfJson camera) {
      return m_target.add("cameras", std::move(camera));
    });
  if (out.erase("skin")) leave_out("skins (geometry is in bind pose)");
  if (out.erase("weights")) leave_out("morph target weights");
  if (const GltfJson& light = member(member(out, "extensions"), "KHR_lights_punctual");
      !light.is_null())
    out["extensions"]["KHR_lights_punctual"]["light"] = copy_light(source, member(light, "light"));
  if (!member(member(out, "extensions"), gltf::kInstancing).is_null())
    for (auto& [name, accessor] : out["extensions"][gltf::kInstancing]["attributes"].items())
      accessor = copy_accessor(source, accessor);
  GltfJson children = GltfJson::array();
  for (const GltfJson& child : member(out, "children"))
    children.push_back(copy_node(source, static_cast<int>(index_from(child)), depth + 1));
  if (children.empty())
    out.erase("children");
  else
    out["children"] = std::move(children);
  return m_target.add("nodes", std::move(out));
}

size_t GltfCopier::copy_mesh(const GltfDocument& source, const GltfJson& mesh) {
  return once(source, "meshes", mesh, [&](GltfJson out) {
    if (out.erase("weights")) leave_out("morph target weights");
    for (GltfJson& primitive : out["primitives"])
      primitive = primitive_of(source, std::move(primitive));
    return m_target.add("meshes", std::move(out));
  });
}

GltfJson GltfCopier::primitive_of(const GltfDocument& source, GltfJson primitive) {
  keep_known_extensions(source, primitive);
  if (!member(member(primitive, "extensions"), gltf::kDraco).is_null()) {
    GltfJson& view = primitive["extensions"][gltf::kDraco]["bufferView"];
    view = copy_view(source, view);
  }
  const auto copy_attributes = [&](const GltfJson& attributes) {
    GltfJson out = GltfJson::object();
    for (const auto& [name, accessor] : attributes.items()) {
      const bool skinning = name.rfind("JOINTS_", 0) == 0 || name.rfind("WEIGHTS_", 0) == 0;
      if (!skinning) out[name] = copy_accessor(source, accessor);
    }
    return out;
  };
  primitive["attributes"] = copy_attributes(member(primitive, "attributes"));
  if (primitive.contains("indices"))
    primitive["indices"] = copy_accessor(source, primitive["indices"]);
  if (primitive.contains("material"))
    primitive["material"] = copy_material(source, primitive["material"]);
  if (primitive.contains("targets"))
    for (GltfJson& target : primitive["targets"]) target = copy_attributes(target);
  return primitive;
}

size_t GltfCopier::copy_accessor(const GltfDocument& source, const GltfJson& index) {
  return once(source, "accessors", index, [&](GltfJson out) {
    if (out.contains("bufferView")) out["bufferView"] = copy_view(source, out["bufferView"]);
    if (out.contains("sparse"))
      for (const char* part : {"indices", "values"}) {
        GltfJson& view = out["sparse"][part]["bufferView"];
        view = copy_view(source, view);
      }
    return m_target.add("accessors", std::move(out));
  });
}

size_t GltfCopier::copy_view(const GltfDocument& source, const GltfJson& index) {
  return once(source, "bufferViews", index, [&](GltfJson out) {
    const size_t offset = index_from(member(out, "byteOffset"));
    const size_t length = index_from(member(out, "byteLength"));
    if (offset > source.binary.size() || length > source.binary.size() - offset)
      bad_input("a buffer view extends beyond its buffer");
    const std::string_view bytes = std::string_view(source.binary).substr(offset, length);
    return m_target.add_view(std::move(out), bytes, offset % 4);
  });
}

size_t GltfCopier::copy_material(const GltfDocument& source, const GltfJson& index) {
  return once(source, "materials", index, [&](GltfJson out) {
    remap_textures(source, out, 0);
    return m_target.add("materials", std::move(out));
  });
}

// Members named ...Texture with an index refer to a texture, in extensions too.
void GltfCopier::remap_textures(const GltfDocument& source, GltfJson& object, int depth) {
  if (!object.is_object() || depth > 8) return;
  if (depth > 0) keep_known_extensions(source, object);
  for (auto& [key, value] : object.items()) {
    if (!value.is_object() || key == "extras") continue;
    if (is_texture_key(key) && value.contains("index"))
      value["index"] = copy_texture(source, value["index"]);
    remap_textures(source, value, depth + 1);
  }
}

size_t GltfCopier::copy_texture(const GltfDocument& source, const GltfJson& index) {
  return once(source, "textures", index, [&](GltfJson out) {
    if (out.contains("sampler"))
      out["sampler"] = once(source, "samplers", out["sampler"], [&](GltfJson sampler) {
        return m_target.add("samplers", std::move(sampler));
      });
    copy_image(source, out);
    if (out.contains("extensions"))
      for (auto& [name, content] : out["extensions"].items()) copy_image(source, content);
    return m_target.add("textures", std::move(out));
  });
}

// A texture without its image is legal; an image without content is not.
void GltfCopier::copy_image(const GltfDocument& source, GltfJson& texture) {
  if (!texture.is_object() || !texture.contains("source")) return;
  const size_t index = index_from(texture["source"]);
  if (index < source.images.size() && !source.images[index]) {
    const GltfJson& image = element(source.json, "images", texture["source"]);
    leave_out(
        say("the image \"%1\", missing, outside the model's folder, or neither PNG, JPEG nor "
            "WebP",
            printable(name_of(image), 100)));
    texture.erase("source");
    return;
  }
  texture["source"] = once(source, "images", texture["source"], [&](GltfJson out) {
    const SharedBytes& bytes = source.images.at(index);
    const std::string type = image_type(*bytes);
    if (!type.empty()) out["mimeType"] = type;
    return m_target.add_image(std::move(out), bytes);
  });
}

size_t GltfCopier::copy_light(const GltfDocument& source, const GltfJson& index) {
  const Key key{&source, "lights", index_from(index)};
  if (const auto found = m_copied.find(key); found != m_copied.end()) return found->second;
  const size_t id = m_target.add_light(element(lights_of(source), "lights", index));
  m_copied.emplace(key, id);
  return id;
}

}  // namespace trivet
