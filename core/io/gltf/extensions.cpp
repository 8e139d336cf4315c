#include "core/io/gltf/extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/bad_input.h"
#include "core/base/printable.h"

namespace trivet::gltf {
namespace {

constexpr const char *kMeshopt = "EXT_meshopt_compression",
                     *kMeshoptKhr = "KHR_meshopt_compression";

constexpr std::array<std::string_view, 13> kKnown = {"KHR_texture_transform",
                                                     "KHR_lights_punctual",
                                                     "KHR_mesh_quantization",
                                                     "KHR_node_visibility",
                                                     "KHR_texture_basisu",
                                                     "EXT_texture_webp",
                                                     "EXT_texture_avif",
                                                     "MSFT_texture_dds",
                                                     kMeshopt,
                                                     kMeshoptKhr,
                                                     kDraco,
                                                     kInstancing,
                                                     "KHR_animation_pointer"};

// Extensions of materials change how a surface looks, not where it is.
bool is_of_materials(const std::string& extension) {
  return extension.rfind("KHR_materials_", 0) == 0;
}

}  // namespace

bool is_known(const std::string& extension) {
  if (std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end()) return true;
  return is_of_materials(extension) && extension != "KHR_materials_variants";
}

void check_required(const std::string& path, const GltfJson& root) {
  std::string missing;
  for (const GltfJson& name : member(root, "extensionsRequired")) {
    if (!name.is_string()) bad_input("an entry of \"extensionsRequired\" is no text");
    const auto extension = name.get<std::string>();
    if (is_known(extension) || is_of_materials(extension)) continue;
    missing += (missing.empty() ? "" : ", ") + printable(extension, 100);
  }
  if (!missing.empty())
    bad_file(path, "requires %1, which Trivet does not have; accepted: files that do without",
             printable(missing));
}

const GltfJson& compression_of(const GltfJson& view) {
  const GltfJson& extensions = member(view, "extensions");
  const GltfJson& khr = member(extensions, kMeshoptKhr);
  return khr.is_null() ? member(extensions, kMeshopt) : khr;
}

bool is_placeholder(const GltfJson& buffer) {
  return member(compression_of(buffer), "fallback") == true;
}

void drop_extension(GltfJson& object, const char* name) {
  const auto found = object.find("extensions");
  if (found == object.end()) return;
  found->erase(name);
  if (found->empty()) object.erase("extensions");
}

void drop_compression(GltfJson& view) {
  for (const char* const name : {kMeshopt, kMeshoptKhr}) drop_extension(view, name);
}

}  // namespace trivet::gltf
