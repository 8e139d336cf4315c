// The float32 positions that exported files hold: the exact check and the writers share them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/model/model.h"

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

/// Origin of one object in a scene that is wide, too: relative to that of the scene, metres. Zero
/// near it; for an object farther than 16 m and 4 of its own sizes a point of a grid of powers of
/// two, which float32 has. Depends on the object alone.
/// @param from_object  to coordinates relative to the scene's origin.
Vec3 export_place(const Affine& from_object, const Aabb& mesh_box);

/// The same transform with world coordinates relative to `origin`.
inline Affine relative_to(const Vec3& origin, Affine world_from_object) {
  world_from_object.translation -= origin;
  return world_from_object;
}

/// Position of a vertex as a reader of the glTF computes it, in doubles (world, z up): the float32
/// vertex, in double through the nodes below the object's own as in read_model(), then through the
/// object's float32 matrix, rounded to float32; then, in double, from its export_place(). The exact
/// check of a float32 export tests these positions; the code that writes the file computes them.
class ExportedPlacement {
 public:
  /// @param object  its model may be null: of no appearance. @param mesh_box  of its mesh.
  /// @throws Error (BadInput) naming the object when its pose is beyond the range of float32.
  ExportedPlacement(const ExportObject& object, const Aabb& mesh_box);
  Vec3 operator()(const Vec3& vertex) const;
  const Vec3& place() const { return m_place; }

 private:
  Vec3 m_place, m_centre;
  bool m_has_look;
  Affine m_y_up_from_local;  // float32 entries
};

/// All vertices of the mesh through ExportedPlacement, rounded once more where that has a place:
/// those of formats without nodes.
std::vector<Eigen::Vector3f> exported_positions(const ExportObject& object);

/// Origin of the object's node: zero unless the mesh lies far from its own origin, where a float32
/// matrix loses digits. Coordinates are float32 numbers for models with an appearance.
/// @param model  null: of no appearance.
Vec3 export_centre(const Model* model, const Aabb& mesh_box);

/// The object with its pose relative to `origin`.
ExportObject relative_to(const Vec3& origin, ExportObject object);

/// Vertices as stored in the file for models without an appearance: object frame minus `centre`,
/// rounded to float32.
struct LocalVertices {
  Vec3 centre = Vec3::Zero();
  std::vector<Eigen::Vector3f> positions;
};
LocalVertices local_vertices(const Model& model);

/// Three rows of the float32 matrix that takes local vertices to the world, y up as in glTF:
/// (x, y, z) of the world is written (x, z, -y). No entry is -0.
using NodeMatrix = std::array<std::array<float, 4>, 3>;

/// @throws Error (BadInput) naming the object if an entry is not a finite float32.
NodeMatrix node_matrix(const ExportObject& object, const Vec3& centre);

}  // namespace trivet
