#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/export.h"
#include "core/io/glb_container.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

// dump() recurses; a hostile file must not exhaust the stack.
constexpr int kMaxDepth = 200;

Json parse(const std::string& path, const std::string& text) {
  const auto check_depth = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxDepth)
      throw Error(Error::Kind::BadInput, path + ": the JSON of the glTF is nested deeper than " +
                                             std::to_string(kMaxDepth) + " levels");
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::exception& e) {
    throw Error(Error::Kind::BadInput, path + ": the JSON of the glTF is broken: " + e.what());
  }
}

// References, as extras may be large; null where the file has nothing of the kind.
const Json& member(const Json& object, const char* key) {
  static const Json none;
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

std::string dump_extras(const Json& object) {
  const Json& extras = member(object, "extras");
  return extras.is_null() ? "" : extras.dump();
}

std::string name_of(const Json& node) {
  const Json& name = member(node, "name");
  return name.is_string() ? name.get<std::string>() : "";
}

}  // namespace

SceneExtras read_scene_extras(const std::string& path) {
  const Json root = parse(path, read_glb_json(path));
  if (!member(root, "asset").is_object())
    throw Error(Error::Kind::BadInput, path + ": is no glTF: its JSON has no asset");
  SceneExtras out;
  const Json& scenes = member(root, "scenes");
  const Json& scene = member(root, "scene");
  const size_t id = scene.is_number_unsigned() ? scene.get<size_t>() : 0;
  if (scenes.is_array() && id < scenes.size()) out.scene_json = dump_extras(scenes[id]);
  const Json& nodes = member(root, "nodes");
  if (!nodes.is_array()) return out;
  for (const Json& node : nodes)
    if (std::string extras = dump_extras(node); !extras.empty())
      out.node_json.emplace_back(name_of(node), std::move(extras));
  return out;
}

}  // namespace trivet
