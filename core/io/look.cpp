#include "core/io/look.h"

#include "core/base/error.h"
#include "core/io/gltf/copy.h"
#include "core/io/gltf/plain.h"
#include "core/io/json.h"

namespace trivet {
std::shared_ptr<const Appearance> appearance_of_gltf(const GltfDocument& source,
                                                     const std::vector<int>& roots,
                                                     std::vector<Sentence>& notes) {
  const auto give_up = [&](const Sentence& reason) {
    notes.push_back(say("hierarchy and textures left out: %1", reason));
    return nullptr;
  };
  try {
    GltfPart part = copied_part(source, roots);
    check_plain(part.document.json);
    for (const auto& [english, what] : part.left_out) notes.push_back(say("left out: %1", what));
    if (!member(source.json, "animations").empty()) notes.push_back("left out: animations");
    Appearance look;
    look.roots = std::move(part.roots);
    look.document = std::make_shared<const GltfDocument>(std::move(part.document));
    return std::make_shared<const Appearance>(std::move(look));
  } catch (const Error& e) {
    return give_up(e.sentence());
  } catch (const GltfJson::exception& e) {
    return give_up(complaint_of(e));
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
