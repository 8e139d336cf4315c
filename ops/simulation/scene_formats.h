// All formats in which a laid-out scene is written, for the command line and the editor.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "ops/files/report/scene_file.h"

namespace trivet {

struct SceneFormat {
  enum class Kind {
    Scene,      // meshes, for other programs; of .glb Trivet reads all back
    Simulator,  // with masses, friction and convex parts; see simulation.h
    Table,      // a row per object; see tables.h
  };
  Kind kind;
  std::string name;  // for people: "glTF", "MuJoCo"
  std::vector<std::string> extensions;
};

/// The order in which people are offered them.
const std::vector<SceneFormat>& scene_formats();
/// ".glb", ".gltf", ... of these kinds.
std::vector<std::string> extensions_of(std::initializer_list<SceneFormat::Kind> kinds);
/// Null: the file has no extension of these.
const SceneFormat* format_of(const std::string& path);

/// Writes by extension, with the default options of the format.
/// @param scene  for simulators with links and least_friction.
/// @param layout  see write_scene_file().
/// @throws Error (BadInput) for an extension of no format; as write_scene_file(),
///   export_simulation() and write_table().
void write_in_any_format(const Scene& scene, const Layout& layout, const SceneFileOptions& options,
                         const std::string& path);

}  // namespace trivet
