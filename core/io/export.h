// Scenes to files: glTF 2.0, OBJ, PLY, STL. Files are replaced atomically.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/io/model.h"

namespace trivet {

/// One object of an exported scene.
struct ExportObject {
  std::string name;
  std::shared_ptr<const Model> model;  // shared: stored once in the file
  Affine world_from_object;
  std::string extras_json;  // glTF `extras` of the node; empty: none
};

/// Origin of a scene's exported float32 positions, metres. Zero near the world's origin; for a
/// scene that reaches farther than 16 m and 8 of its diagonals a grid point near it: float32 digits
/// then describe the scene, not its distance. Depends on the box alone.
Vec3 export_origin(const Aabb& scene_box);

/// The same transform with world coordinates relative to `origin`.
inline Affine relative_to(const Vec3& origin, Affine world_from_object) {
  world_from_object.translation -= origin;
  return world_from_object;
}

struct ExportScene {
  std::vector<ExportObject> objects;
  std::string extras_json;  // glTF `extras` of the scene; empty: none
  /// Origin of the written positions: export_origin(). glTF has a root node that translates back,
  /// in double; OBJ, PLY and STL name it in their headers.
  Vec3 origin = Vec3::Zero();
};

/// Position of a vertex as a reader of the glTF computes it, in doubles (world, z up): the float32
/// vertex, in double through the nodes below the object's own as in read_model(), then through the
/// object's float32 matrix, rounded to float32. The exact check of a float32 export tests these
/// positions; the code that writes the file computes them.
class ExportedPlacement {
 public:
  /// @param object  its model may be null: of no appearance. @param mesh_box  of its mesh.
  /// @throws Error (BadInput) naming the object when its pose is beyond the range of float32.
  ExportedPlacement(const ExportObject& object, const Aabb& mesh_box);
  Vec3 operator()(const Vec3& vertex) const;

 private:
  Vec3 m_centre;
  bool m_has_look;
  Affine m_y_up_from_local;  // float32 entries
};

/// All vertices of the mesh through ExportedPlacement.
std::vector<Eigen::Vector3f> exported_positions(const ExportObject& object);

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

/// Writes bytes atomically: temporary file in the same folder, fsync, rename.
/// @throws Error (Environment) naming the path and the system's reason; no partial output is left.
void write_file_atomically(const std::string& path, const std::string& bytes);
/// The same for content too large for memory: `content` passes it on piece by piece.
using ByteSink = std::function<void(const std::string& bytes)>;
using FileContent = std::function<void(const ByteSink& write)>;
void write_file_atomically(const std::string& path, const FileContent& content);

/// The extras of a .glb as JSON text: of the scene (empty: none), and of each node that has any, by
/// the node's name.
struct SceneExtras {
  std::string scene_json;
  std::vector<std::pair<std::string, std::string>> node_json;
};
/// @throws Error (BadInput) if the file is not binary glTF.
SceneExtras read_scene_extras(const std::string& path);

}  // namespace trivet
