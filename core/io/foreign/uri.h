// Meshes and models that URDF and SDF name by URIs.
#pragma once

#include <string>

#include "core/io/foreign/scene_roots.h"
#include "core/model/model.h"

namespace trivet {

/// A path for "package://NAME/FILE", "model://NAME/FILE", "file://FILE" or a path relative to the
/// file that names it. NAME is looked for in the folders above. @throws Error (BadInput): a URI
/// that would have to be fetched, a path outside the roots.
std::string path_of_uri(const std::string& uri, const std::string& named_by,
                        const SceneRoots& roots);

/// COLLADA states its unit and its up axis; others are taken as they are.
Mesh mesh_in_metres(const Model& model);

/// Mirrored scales turn the faces.
void scale(const Vec3& factors, Mesh& mesh);

}  // namespace trivet
