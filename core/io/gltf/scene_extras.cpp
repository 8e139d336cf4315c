#include "core/base/error.h"
#include "core/io/export.h"
#include "core/io/gltf/document.h"

namespace trivet {
namespace {

std::string dump_extras(const GltfJson& object) {
  const GltfJson& extras = member(object, "extras");
  return extras.is_null() ? "" : extras.dump();
}

}  // namespace

SceneExtras read_scene_extras(const std::string& path) {
  const GltfJson root = parse_gltf_json(path, read_gltf_text(path));
  if (!member(root, "asset").is_object())
    throw Error(Error::Kind::BadInput,
                "%1: is not glTF: its JSON has no asset; accepted: a scene, which trivet run makes "
                "of a layout",
                path);
  SceneExtras out;
  const GltfJson& scenes = member(root, "scenes");
  const GltfJson& scene = member(root, "scene");
  const size_t id = scene.is_number_unsigned() ? scene.get<size_t>() : 0;
  if (scenes.is_array() && id < scenes.size()) out.scene_json = dump_extras(scenes[id]);
  const GltfJson& nodes = member(root, "nodes");
  if (!nodes.is_array()) return out;
  for (const GltfJson& node : nodes)
    if (std::string extras = dump_extras(node); !extras.empty())
      out.node_json.emplace_back(name_of(node), std::move(extras));
  return out;
}

}  // namespace trivet
