// Corner normals for shading, computed where files have none.
#pragma once

#include <array>
#include <vector>

#include "core/mesh/mesh.h"

namespace trivet {

using CornerNormals = std::vector<std::array<Eigen::Vector3f, 3>>;

/// Smooth corner normals: at a vertex, faces whose normals differ by less than the crease angle
/// (40 degrees) are shaded as one surface, weighted by area.
/// @return #F x 3, unit, object frame; faces without area get their neighbours' normal, else +z.
/// Cost O(sum of squared valences), flat above valence 256.
CornerNormals smooth_normals(const Mesh& mesh);

/// Replaces zero normals by smooth ones.
void fill_missing_normals(const Mesh& mesh, CornerNormals& normals);

}  // namespace trivet
