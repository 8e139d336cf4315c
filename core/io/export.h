// Scenes to files: glTF 2.0, OBJ, PLY, STL. Files are replaced atomically.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/model/exported_floats.h"

namespace trivet {

struct ExportScene {
  std::vector<ExportObject> objects;
  std::string extras_json;  // glTF `extras` of the scene; empty: none
  /// Origin of the written positions: export_origin(). glTF has a root node that translates back,
  /// in double; OBJ, PLY and STL name it in their headers.
  Vec3 origin = Vec3::Zero();
};

/// Writes by extension: .glb; .gltf (with .bin and images beside it); .obj (with .mtl beside it),
/// .ply and .stl, which hold the coordinates of exported_positions(). glTF holds a model with its
/// full appearance (Model::look), once per model. Objects without triangles become empty nodes.
/// Writes beside the target and renames, so that the target is either the old file or the whole new
/// one. Companion files are replaced only if the old target names them.
///
/// @throws Error: BadInput for an unknown extension, or if a companion file belongs to another
///   scene; Environment if it cannot be written.
void write_scene(const ExportScene& scene, const std::string& path);

/// The bytes of a format that is one file: ".glb", ".ply", ".stl".
/// @throws Error (BadInput) for another extension.
std::string scene_bytes(const ExportScene& scene, const std::string& extension);

/// Checks the companion files that are known without a scene: the .bin of a .gltf, the .mtl of an
/// .obj.
/// @throws Error (BadInput) naming the file in the way.
void check_files_beside(const std::string& path);

/// Checks that the companion file `beside`, in the folder of the glTF or OBJ `path`, may be
/// written: it does not exist, or the existing `path` names it. @throws Error (BadInput) if not.
void check_file_beside(const std::string& path, const std::string& beside);

/// The extras of a .glb as JSON text: of the scene (empty: none), and of each node that has any, by
/// the node's name.
struct SceneExtras {
  std::string scene_json;
  std::vector<std::pair<std::string, std::string>> node_json;
};
/// @throws Error (BadInput) if the file is not binary glTF.
SceneExtras read_scene_extras(const std::string& path);

}  // namespace trivet
