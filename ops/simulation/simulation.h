// A laid-out scene for physics simulators: masses, inertias, friction and convex parts of its
// objects, and which parts overlap.
#pragma once

#include <string>
#include <vector>

#include "core/io/simulators/simulation_scene.h"
#include "core/scene/scene.h"

namespace trivet {

/// Collision geometry of simulators.
enum class CollisionRule {
  Hull,           // one convex hull per object
  Components,     // a hull per component of the mesh
  Decomposition,  // components that are not convex are cut into pieces
  Mesh,           // the triangles themselves; not for MuJoCo, which takes their hull
};
CollisionRule collision_rule_from_name(const std::string& name);
const std::vector<std::string>& collision_rule_names();  // "hull", "components", ...
const char* to_string(CollisionRule rule);
/// @throws Error (BadInput) when the format of the file, or this build, has no such rule.
void check_collision_rule(CollisionRule rule, const std::string& path);

struct SimulationOptions {
  double density = 1000;  // kg/m^3; objects without volume weigh as a wall of kWallThickness
  double friction = 0.6;  // of everything; more where an object needs it, see below
  CollisionRule collision = CollisionRule::Components;
  double hull_clearance = 0;  // metres by which faces of convex parts are moved inwards
  SimulationFileOptions files;
};

/// Two objects whose parts overlap, though their triangles do not: simulators push them apart.
struct PartOverlap {
  std::string a, b;  // names; "floor"
  double depth = 0;  // metres, of the deepest pair of parts
  int num_part_pairs = 0;
};

struct SimulationExport {
  SimulationScene scene;
  std::vector<PartOverlap> overlaps;  // deepest first
  std::vector<std::string> notes;
  std::vector<std::string> files;  // the scene file first
};

/// Masses by the objects' mass rules, inertias exact. An object's friction is the option, or a
/// quarter more than what it, or something on it, needs to stay (`least_friction`) where that is
/// more: whichever way a simulator combines two coefficients, it is enough.
/// @param scene  with links and least_friction; objects that are not placed are left out.
/// @param name  of the scene, in the file.
/// @throws Error (BadInput): an object without size, Decomposition in a build without it.
SimulationExport simulation_of(const Scene& scene, const std::string& name,
                               const SimulationOptions& options);

/// simulation_of(), written; see write_simulation(). Named after the file.
SimulationExport export_simulation(const Scene& scene, const std::string& path,
                                   const SimulationOptions& options = {});

/// The export as JSON: {"files", "density", "collision", "objects": [{"name", "file_name", "fixed",
/// "mass", "friction", "parts"}], "overlaps": [{"a", "b", "depth", "part_pairs"}],
/// "notes"}.
std::string simulation_json(const SimulationExport& done, const SimulationOptions& options);
/// For people: a few lines.
std::string simulation_text(const SimulationExport& done);

}  // namespace trivet
