// Robots and furniture as URDF.
#pragma once

#include "core/io/foreign/scene.h"

namespace trivet {

/// Links that fixed joints connect are one body; the others hang in joints and stay at the value 0
/// (within its limits). A floating joint makes a body free; so does a root link where
/// `options.fixed_base` is false and nothing hangs in it by joints. Colliding meshes are their
/// hulls unless `options.true_meshes`. "package://NAME/" is looked for in folders above the file.
/// @throws Error (BadInput) naming the file, the line and the element.
ForeignScene read_urdf(const std::string& path, const ForeignOptions& options,
                       const MeshSource& meshes);

}  // namespace trivet
