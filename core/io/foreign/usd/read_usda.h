// Stages of USD as text, with the schemas UsdGeom and UsdPhysics.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/io/foreign/scene.h"
#include "core/io/foreign/usd/usda_frames.h"

namespace trivet {

/// Knowledge of the layers below that an over layer needs.
struct UsdaSource {
  std::vector<std::vector<UsdaPlace>> places;                 // see PosePlace::number
  std::vector<std::pair<std::string, std::string>> metadata;  // of the main layer, as text
};

/// Prims with PhysicsRigidBodyAPI are bodies of all colliders below them. Other colliders are
/// fixed: one body for each asset, else for each prim. Bodies in joints stay where they are; fixed
/// joints alone make one body of several. Meshes collide as they are, or as their hulls where
/// physics:approximation says convexHull.
/// @throws Error (BadInput) naming the file and the line.
ForeignScene read_usda(const std::string& path, const ForeignOptions& options,
                       const MeshSource& meshes);

/// A layer that lies over the scene's main one and gives bodies new poses.
/// @param poses  in the world of the file, by index into ForeignScene::bodies.
/// @param below  path of the main layer, from where the new one will be.
/// @throws Error (BadInput) naming a body without a place.
std::string usda_over_layer(const ForeignScene& scene, const std::map<size_t, Pose>& poses,
                            const std::string& below);

}  // namespace trivet
