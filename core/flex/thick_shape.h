// Solids around the middle surfaces of sheets and the lines of cables.
#pragma once

#include "core/flex/body.h"
#include "core/mesh/mesh.h"

namespace trivet::flex {

/// Closed, of vertices that no other part shares.
struct ThickShape {
  Mesh mesh;
  std::vector<std::array<Eigen::Vector3f, 3>> corner_normals;  // of the faces: smooth but at rims
};

/// Both sides of a sheet and its rim. No point is farther than `radius` from the middle surface:
/// what keeps that distance from the middle does not meet it.
ThickShape thick_sheet(const Points& middle, const std::vector<std::array<int, 3>>& faces,
                       double radius);

/// A tube of twelve sides around a line, with flat ends; inside `radius` likewise.
ThickShape thick_cable(const Points& line, double radius);

}  // namespace trivet::flex
