// Scenes for physics simulators.
#pragma once

#include "trivet/scene.h"

TRIVET_BEGIN

struct ExportOptions {
  std::string collision = "fitted";  // "hull", "components", "decomposition", "mesh"
  std::optional<double> density;     // kg/m^3 of everything; nullopt: of the materials
  std::optional<double> friction;    // of everything; nullopt: of the materials
  double max_overlap = 0;            // metres that parts may overlap; 0: 1e-4 of the smaller object
  int mujoco = 3;                    // version of MuJoCo that reads it: 3, or 2
};

struct Export {
  std::vector<std::string> files;  // the scene first
  std::vector<std::string> notes;
};

/// By extension: .xml (MuJoCo), .urdf, .sdf, .usda; meshes go into a folder beside it.
/// @throws Error (BadInput) when convex parts of different objects overlap by more than is allowed;
///   nothing is written then.
TRIVET_API Export export_scene(const Scene& scene, const std::string& path,
                               const ExportOptions& options = {});

TRIVET_END
