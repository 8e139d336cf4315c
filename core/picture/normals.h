// Smooth normals of a mesh, for pictures.
#pragma once

#include "core/picture/scene.h"

namespace trivet {

/// Unit normals per triangle corner, object frame: the file's if usable, else the mean of the faces
/// around the vertex that meet this one at less than the crease angle.
/// @return #F x 3.
std::vector<std::array<Eigen::Vector3f, 3>> picture_normals(const PictureMesh& mesh);

}  // namespace trivet
