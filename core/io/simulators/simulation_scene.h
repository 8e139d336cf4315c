// Scenes for physics simulators: MuJoCo MJCF, URDF, SDF, USD. What a scene is for all of them, and
// writing it; ops/simulation makes it of a Scene.
//
// A body's link frame has the metre and the z axis up; it is the object's pose, so that a body's
// position is that of a layout (of models far from their own origin: a centre near them).
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/convex/convex_parts.h"
#include "core/io/model.h"

namespace trivet {

/// What objects of one model, scale and up axis share: files of meshes.
struct SimulationModel {
  std::string name;
  std::shared_ptr<const Model> model;
  Affine link_from_object;
  std::vector<ConvexPart> parts;  // what collides; none: the triangles themselves
};

struct SimulationBody {
  std::string name;       // as the user knows it
  std::string file_name;  // valid and unique in the format; write_simulation() sets it
  size_t model = 0;
  Pose world_from_link;
  bool fixed = false;
  double mass = 0;              // kilograms
  Vec3 centre = Vec3::Zero();   // of mass, link frame
  Mat3 inertia = Mat3::Zero();  // kg m^2, about `centre`, axes of the link frame
  double friction = 0;          // Coulomb's coefficient
};

struct SimulationScene {
  std::string name;
  bool floor = true;  // at z = 0
  double floor_friction = 0;
  double gravity = 9.80665;  // along -z
  std::vector<SimulationModel> models;
  std::vector<SimulationBody> bodies;
};

struct SimulationFileOptions {
  /// Folder of the meshes; relative: to the scene file. Empty: "<stem>_meshes".
  std::string mesh_folder;
  /// Put before the meshes' paths in URDF and SDF, such as "package://my_robot/"; empty: paths
  /// relative to the scene file.
  std::string mesh_prefix;
};

/// Writes .xml or .mjcf (MuJoCo), .urdf, .sdf or .world, .usda. Meshes carry a hash of their
/// content in their names: a mesh file is never changed, scenes may share a folder, and the scene
/// file, written last and atomically, never names a mesh that is not there.
/// @param scene  its bodies get their `file_name`.
/// @return all files that the scene needs, the scene file first.
/// @throws Error: BadInput for an unknown extension, Environment when it cannot be written.
std::vector<std::string> write_simulation(SimulationScene& scene, const std::string& path,
                                          const SimulationFileOptions& options = {});

/// Whether write_simulation() knows the extension, such as ".urdf".
bool is_simulation_extension(const std::string& extension);
/// ".xml, .mjcf, ..."
const std::vector<std::string>& simulation_extensions();

/// Names of ASCII letters, digits, '_' and, if `dashes`, '-' and '.'; a letter or '_' first; no two
/// the same, none in `taken`. Names that are so already stay.
std::vector<std::string> valid_names(const std::vector<std::string>& names, bool dashes,
                                     std::set<std::string> taken);

}  // namespace trivet
