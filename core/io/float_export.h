// What float32 files hold of an object: vertices about a centre, and the node's matrix.
#pragma once

#include <string>
#include <vector>

#include "core/io/export.h"

namespace trivet {

/// What the object's node is about: zero unless the mesh lies far from its own origin, where a
/// float32 matrix loses digits. Models with a look have float32 numbers here.
Vec3 export_centre(const Model& model, const Aabb& mesh_box);

/// Vertices as the file stores them for models without a look: object frame minus `centre`, rounded
/// to float32.
struct LocalVertices {
  Vec3 centre = Vec3::Zero();
  std::vector<Eigen::Vector3f> positions;
};
LocalVertices local_vertices(const Model& model);

/// Three rows of the float32 matrix that takes local vertices to the world, y up as in glTF:
/// (x, y, z) of the world is written (x, z, -y). No entry is -0.
using NodeMatrix = std::array<std::array<float, 4>, 3>;

/// @throws Error (BadInput) naming the object when an entry is no finite float32.
NodeMatrix node_matrix(const ExportObject& object, const Vec3& centre);

}  // namespace trivet
