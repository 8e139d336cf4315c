#include "core/io/gltf/structure.h"

#include "core/base/bad_input.h"

namespace trivet {
namespace {

constexpr const char* kLists[] = {
    "accessors", "animations", "buffers",  "bufferViews",    "cameras",
    "images",    "materials",  "meshes",   "nodes",          "samplers",
    "scenes",    "skins",      "textures", "extensionsUsed", "extensionsRequired"};

void check_kind(const GltfJson& value, const std::string& place, bool as_it_should_be,
                const Sentence& accepted) {
  if (!as_it_should_be)
    bad_input("%1: has the type %2; accepted: %3", place, value.type_name(), accepted);
}

void check_array(const GltfJson& owner, const char* key, const std::string& place) {
  const GltfJson& list = member(owner, key);
  check_kind(list, place + "/" + key, list.is_null() || list.is_array(), "array");
}

void check_object(const GltfJson& owner, const char* key, const std::string& place) {
  const GltfJson& item = member(owner, key);
  check_kind(item, place + "/" + key, item.is_null() || item.is_object(), "object");
}

void check_objects(const GltfJson& owner, const char* key, const std::string& place) {
  check_array(owner, key, place);
  const GltfJson& list = member(owner, key);
  for (size_t i = 0; i < list.size(); ++i)
    check_kind(list[i], place + "/" + key + "/" + std::to_string(i), list[i].is_object(), "object");
}

void check_mesh(const GltfJson& mesh, const std::string& place) {
  check_objects(mesh, "primitives", place);
  const GltfJson& primitives = member(mesh, "primitives");
  for (size_t i = 0; i < primitives.size(); ++i) {
    const std::string primitive = place + "/primitives/" + std::to_string(i);
    check_object(primitives[i], "attributes", primitive);
    check_object(primitives[i], "extensions", primitive);
    check_objects(primitives[i], "targets", primitive);
  }
}

void check_items(const GltfJson& root, const char* key) {
  const GltfJson& list = member(root, key);
  const std::string name = key;
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string place = "/" + name + "/" + std::to_string(i);
    check_object(list[i], "extensions", place);
    if (name == "meshes") check_mesh(list[i], place);
    if (name == "nodes") check_array(list[i], "children", place);
    if (name == "scenes") check_array(list[i], "nodes", place);
  }
}

}  // namespace

void check_structure(const GltfJson& root) {
  if (!member(root, "asset").is_object()) bad_input("the JSON has no \"asset\" object");
  for (const char* const key : kLists) {
    if (std::string(key).starts_with("extensions")) {
      check_array(root, key, "");
      continue;
    }
    check_objects(root, key, "");
    check_items(root, key);
  }
}

}  // namespace trivet
