// Scenes of MuJoCo (MJCF).
#pragma once

#include "core/io/foreign/scene.h"

namespace trivet {

/// Bodies without joints between are one; those in the world are one each. Bodies that joints hold
/// stay where a keyframe has them (the first one with qpos, or `options.key`), else where the model
/// does. What collides is what MuJoCo collides: meshes by their hulls, pairs by contype,
/// conaffinity, exclude and kinship.
/// @throws Error (BadInput) naming the file, the line and the element.
ForeignScene read_mjcf(const std::string& path, const ForeignOptions& options,
                       const MeshSource& meshes);

}  // namespace trivet
