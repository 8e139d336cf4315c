// Colliders and masses of links of SDF. Private to their reader.
#pragma once

#include "core/io/foreign/scene.h"
#include "core/io/foreign/scene_roots.h"
#include "core/io/foreign/xml_text.h"

namespace trivet {

/// Files of meshes: how they are read, and folders in which they may be.
struct SdfMeshes {
  const MeshSource& read;
  const SceneRoots& allowed;
};

/// Adds a <collision>. Shapes that are not read are noted in scene.unread.
/// @param pose  in the body. @throws Error (BadInput) naming the place, for numbers out of range.
void add_sdf_collision(const XmlNode& collision, const Pose& pose, const SdfMeshes& meshes,
                       ForeignScene& scene, ForeignBody& body);

/// Adds the mass of a <link>: a kilogram, and moments of 1 kg m2, where it gives none.
/// @param in_body  pose of the link.
void add_sdf_mass(const XmlNode& link, const Pose& in_body, const std::vector<XmlFile>& files,
                  ForeignBody& body);

/// Notes that an element is left out.
void skip_sdf(const XmlNode& node, const Sentence& why, ForeignScene& scene);

}  // namespace trivet
