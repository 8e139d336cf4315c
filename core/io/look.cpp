#include "core/io/look.h"

#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/io/gltf/component_types.h"
#include "core/io/gltf/copy.h"

namespace trivet {
namespace {

// Rejects integer positions, allowed by extensions, and sparse ones: importers differ there.
void check_positions(const GltfJson& root) {
  for (const GltfJson& mesh : member(root, "meshes"))
    for (const GltfJson& primitive : member(mesh, "primitives")) {
      const GltfJson& position = member(member(primitive, "attributes"), "POSITION");
      if (position.is_null()) continue;
      const GltfJson& accessor = element(root, "accessors", position);
      if (member(accessor, "componentType") != gltf::kFloat || accessor.contains("sparse"))
        throw Error(Error::Kind::BadInput, "positions that are not plain float32");
    }
}

}  // namespace

std::shared_ptr<const Appearance> appearance_of_gltf(const GltfDocument& source,
                                                     const std::vector<int>& roots,
                                                     std::vector<Sentence>& notes) {
  const auto give_up = [&](const Sentence& reason) {
    notes.push_back(say("hierarchy and textures left out: %1", reason));
    return nullptr;
  };
  try {
    GltfBuilder builder;
    GltfCopier copier(builder);
    Appearance look;
    for (const int root : roots)
      look.roots.push_back(static_cast<int>(copier.copy_tree(source, root)));
    auto document = std::make_shared<GltfDocument>(builder.take(GltfJson::object()));
    check_positions(document->json);
    for (const auto& [english, what] : copier.left_out())
      notes.push_back(say("left out: %1", what));
    if (!member(source.json, "animations").empty()) notes.push_back("left out: animations");
    look.document = std::move(document);
    return std::make_shared<const Appearance>(std::move(look));
  } catch (const Error& e) {
    return give_up(e.sentence());
  } catch (const GltfJson::exception& e) {
    return give_up(printable(e.what()));
  }
}

AppearanceCounts count(const Appearance& look) {
  const GltfJson& root = look.document->json;
  const auto size = [&](const char* list) { return member(root, list).size(); };
  AppearanceCounts out;
  out.nodes = size("nodes"), out.meshes = size("meshes"), out.materials = size("materials");
  out.textures = size("textures"), out.images = size("images"), out.cameras = size("cameras");
  for (const SharedBytes& bytes : look.document->images)
    out.image_bytes += bytes ? bytes->size() : 0;
  const GltfJson& lights = member(member(root, "extensions"), "KHR_lights_punctual");
  out.lights = member(lights, "lights").size();
  return out;
}

}  // namespace trivet
