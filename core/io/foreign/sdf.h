// Worlds and models of Gazebo (SDF).
#pragma once

#include "core/io/foreign/scene.h"

namespace trivet {

/// Models that are not static are free bodies, of all links that fixed joints connect; links that
/// other joints hold stay as they are. Poses follow relative_to, attached_to, nested models and
/// included ones ("model://NAME" is looked for in folders above the file); nothing is fetched.
/// @throws Error (BadInput) naming the file, the line and the element.
ForeignScene read_sdf(const std::string& path, const ForeignOptions& options,
                      const MeshSource& meshes);

}  // namespace trivet
