#include "core/io/gltf/model.h"

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/base/quoted.h"
#include "core/io/gltf/geometry.h"
#include "core/io/gltf/glb_container.h"
#include "core/io/gltf/plain.h"
#include "core/io/json.h"
#include "core/io/look.h"

namespace trivet {
namespace {

// Its lists are objects; its version may be a number, or missing.
bool is_version_1(const GltfJson& root) {
  const GltfJson& version = member(member(root, "asset"), "version");
  if (member(root, "nodes").is_object()) return true;
  return version.is_string() && version.get_ref<const std::string&>().rfind("1.", 0) == 0;
}

// Version 2.x, whose readers ignore what they do not know.
void check_version(const GltfJson& root) {
  const GltfJson& least = member(member(root, "asset"), "minVersion");
  const bool is_later = least.is_string() && least != "2.0";
  const GltfJson& version = is_later ? least : member(member(root, "asset"), "version");
  const bool is_2 =
      version.is_string() && version.get_ref<const std::string&>().rfind("2.", 0) == 0;
  if (is_2 && !is_later) return;
  const std::string given = version.is_string() ? version.get<std::string>() : "unknown";
  bad_input("glTF version %1; accepted: 2", printable(given, 40));
}

void note_other_scenes(const GltfJson& root, Model& model) {
  const GltfJson &scenes = member(root, "scenes"), &shown = member(root, "scene");
  if (scenes.size() < 2) return;
  const size_t number = shown.is_null() ? 0 : index_from(shown);
  std::string names;
  for (size_t i = 0; i < scenes.size() && names.size() < 200; ++i)
    if (i != number)
      names += (names.empty() ? "" : ", ") + quoted(printable(name_of(scenes[i]), 40));
  model.notes.push_back(say("other scenes left out: %1 (%2)", scenes.size() - 1, names));
}

Model model_of(const std::string& path, GltfJson json, const ImportLimits& limits) {
  check_version(json);
  Model model;
  const GltfDocument document =
      plain_gltf(resolved_gltf(path, std::move(json), limits), limits, model.notes);
  model.path = path;
  model.format = "gltf2";
  model.up = UpAxis::Y;
  model.up_from_format = true;
  model.metres_per_unit = 1.0;
  const std::vector<int> roots = scene_roots(document.json);
  note_other_scenes(document.json, model);
  read_gltf_geometry(document, roots, limits, model);
  model.appearance = appearance_of_gltf(document, roots, model.notes);
  return model;
}

}  // namespace

std::optional<Model> read_gltf_model(const std::string& path, const ImportLimits& limits) {
  if (glb_version(path) == 1) return std::nullopt;
  try {
    GltfJson json = parse_gltf_json(path, read_gltf_text(path));
    if (is_version_1(json)) return std::nullopt;
    return model_of(path, std::move(json), limits);
  } catch (const GltfJson::exception& e) {
    bad_file(path, "is not valid glTF: %1", complaint_of(e));
  } catch (const Error& e) {
    if (std::string(e.what()).rfind(path, 0) == 0) throw;
    bad_file(path, e.sentence());
  }
}

}  // namespace trivet
