// Float32 representation of an object: vertices relative to a centre, and the node's matrix.
#pragma once

#include <string>
#include <vector>

#include "core/io/export.h"

namespace trivet {

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
