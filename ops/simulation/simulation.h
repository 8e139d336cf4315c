// A laid-out scene for physics simulators: masses, inertias, friction and convex parts of its
// objects, and which parts overlap.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/convex/surface_probe.h"
#include "core/io/simulators/simulation_scene.h"
#include "core/scene/scene.h"

namespace trivet {

/// Collision geometry of simulators.
enum class CollisionRule {
  Fitted,         // components, split where their hulls would cover other objects; the default
  Hull,           // one convex hull per object
  Components,     // a hull per component of the mesh
  Decomposition,  // components that are not convex are cut into pieces
  Mesh,           // the triangles themselves; not for MuJoCo, which takes their hull
};
CollisionRule collision_rule_from_name(const std::string& name);
const std::vector<std::string>& collision_rule_names();  // "fitted", "hull", ...
const char* to_string(CollisionRule rule);
/// @throws Error (BadInput) when the format of the file, or this build, has no such rule.
void check_collision_rule(CollisionRule rule, const std::string& path);

class PartCache;    // part_cache.h
struct SceneJoint;  // ops/files/foreign/open_scene.h

struct SimulationOptions {
  std::optional<double> density;   // kg/m^3, of everything; none: of the materials
  std::optional<double> friction;  // of everything; none: of the materials
  CollisionRule collision = CollisionRule::Fitted;
  double max_overlap = 0;     // metres; 0: kMaxPartOverlap of the smaller of two objects
  double max_error = 0;       // metres by which fitted parts may stand out of surfaces; 0: any
  double hull_clearance = 0;  // metres by which faces of convex parts are moved inwards
  bool measured = false;      // how far parts stand out of surfaces is measured
  std::shared_ptr<PartCache> cache;  // of scenes with the same models; null: none is kept
  std::shared_ptr<const std::vector<SceneJoint>> joints;  // of the scene; null: it has none
  SimulationFileOptions files;
};

/// Two objects whose parts overlap, though their triangles do not: simulators push them apart.
struct PartOverlap {
  std::string a, b;               // names; "floor"
  size_t body_a = 0, body_b = 0;  // of SimulationScene::bodies; of the floor: the same
  double depth = 0;               // metres, of the deepest pair of parts
  double allowed = 0;             // metres
  int num_part_pairs = 0;
};

struct SimulatedScene;  // see simulate.h

inline constexpr double kMaxPartOverlap = 1e-4;

struct SimulationExport {
  SimulationScene scene;
  std::vector<PartOverlap> overlaps;  // deepest first
  std::vector<StandsOut> stands_out;  // of the models, link frame, metres; empty: not measured
  std::vector<Sentence> notes;
  std::vector<std::string> files;  // the scene file first
};

/// Masses by the objects' mass rules, inertias exact, friction and restitution of the materials.
/// Notes name what needs more friction than its contacts have.
/// @param scene  with links and least_friction; objects that are not placed are left out.
/// @param name  of the scene, in the file.
/// @throws Error (BadInput): an object without size, Decomposition in a build without it.
SimulationExport simulation_of(const Scene& scene, const std::string& name,
                               const SimulationOptions& options);

/// simulation_of(), written; see write_simulation(). Named after the file. Objects that fitted
/// parts cannot follow get their triangles, where the format has them.
/// @throws Error (BadInput) when parts of different objects overlap by more than is allowed, which
///   pushes them apart in a simulator; nothing is written.
SimulationExport export_simulation(const Scene& scene, const std::string& path,
                                   const SimulationOptions& options = {});

/// The export as JSON: {"files", "density", "friction" (a number or "materials"), "collision",
/// "objects": [{"name", "file_name", "fixed", "mass", "friction", "restitution", "parts"}],
/// "overlaps": [{"a", "b", "depth", "allowed", "part_pairs"}], "notes"}.
/// Free objects have "qpos": x, y, z, qw, qx, qy, qz of their joint in MuJoCo, which has their
/// "file_name". Where it was measured, objects have "stands_out": {"distance", "at"}: how far their
/// parts stand out of their surface, and where that is in the world. With a simulation also
/// "simulated": {"simulator", "seconds", "penetration", "warnings", "within_1mm",
/// "within_2mm_2deg", "within_1cm", "objects": [{"name", "moved", "turned_deg", "why"}]}, metres;
/// "why" is a list of what is known, of those that moved by over a millimetre.
std::string simulation_json(const SimulationExport& done, const SimulationOptions& options,
                            const SimulatedScene* simulated = nullptr);
/// For people: a few lines.
std::string simulation_text(const SimulationExport& done);

}  // namespace trivet
