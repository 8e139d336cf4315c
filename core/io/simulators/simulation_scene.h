// Scenes for physics simulators: MuJoCo MJCF, URDF, SDF, USD. Declares the common scene description
// and its writer; ops/simulation makes it from a Scene.
//
// A body's link frame has the metre and the z axis up; it is the object's pose, so that a body's
// position is that of a layout (of models far from their own origin: a centre near them).
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/convex/parts.h"
#include "core/io/simulators/simulation_look.h"
#include "core/model/model.h"

namespace trivet {

/// Data shared by objects of one model, scale and up axis: mesh files.
struct SimulationModel {
  std::string name;
  std::shared_ptr<const Model> model;
  Affine link_from_object;
  Affine file_from_object;  // of mesh files: the axes of the link, in a unit of their own
  double scale = 1;         // metres per unit of the mesh files and parts, which scene files state
  std::vector<ConvexPart> parts;               // collision parts; empty: the triangles themselves
  std::shared_ptr<const SimulationLook> look;  // null: the model's materials say all
};

struct SimulationBody {
  std::string name;       // as given by the user
  std::string file_name;  // valid and unique in the format; write_simulation() sets it
  std::string own_file;   // of it alone, beside the scene file; empty: none; as `file_name`
  size_t model = 0;
  Pose world_from_link;
  bool fixed = false;
  double mass = 0;              // kilograms
  Vec3 centre = Vec3::Zero();   // of mass, link frame
  Mat3 inertia = Mat3::Zero();  // kg m^2, about `centre`, axes of the link frame
  double friction = 0;          // Coulomb's coefficient; of two bodies the smaller one is meant
  double restitution = 0;
  double gap = 0;  // metres: the widest of the contacts by which it rests
};

/// A body that hangs in another. Both are where `value` has them; formats without a place for it
/// count from there.
struct SimulationJoint {
  enum class Kind { Fixed, Slide, Hinge } kind = Kind::Fixed;
  std::string name;                                         // as given by the user
  std::string file_name;                                    // as that of bodies
  size_t child = 0;                                         // a fixed body, in no other joint
  std::optional<size_t> parent;                             // nothing: the world
  std::vector<size_t> apart;                                // bodies that the child passes through
  Vec3 axis = Vec3::UnitX(), anchor = Vec3::Zero();         // link frame of the child; unit axis
  double value = 0, lower = -kInfinity, upper = kInfinity;  // metres or radians
  double friction = 0;                                      // newtons or newton metres
};

struct SimulationScene {
  std::string name;
  bool floor = true;  // at z = 0
  double floor_friction = 0, floor_restitution = 0;
  double floor_gap = 0;      // metres: the widest of the contacts with it
  double gravity = 9.80665;  // along -z
  std::vector<SimulationModel> models;
  std::vector<SimulationBody> bodies;
  std::vector<SimulationJoint> joints;  // trees
  double heaviest_load = 0;             // largest mass that a free body carries, in its own masses
  size_t num_near_parts = 0;  // pairs of parts that may touch, for simulators that want to know
};

struct SimulationFileOptions {
  /// Folder of the meshes; relative: to the scene file. Empty: "<stem>_meshes".
  std::string mesh_folder;
  /// Prefix of mesh paths in URDF and SDF, such as "package://my_robot/"; empty: paths relative to
  /// the scene file.
  std::string mesh_prefix;
  /// Version of MuJoCo whose MJCF is written: 3, or 2, which refuses words of later ones.
  int mujoco = 3;
  /// In MJCF for MuJoCo 3.9 or later free bodies sleep until something touches them.
  bool asleep = false;
  /// The scene is one of many in a folder, whose files are the same for all of them: in the unit of
  /// the model, whatever its size in the scene, and in USD with a layer for each convex part.
  bool for_many_scenes = false;
  /// URDF has a file for each object, too, in the folder of the meshes.
  bool per_object = false;
};
inline constexpr int kOldestMujoco = 2, kNewestMujoco = 3;

/// Writes .xml or .mjcf (MuJoCo), .urdf, .sdf or .world, .usda. Mesh names carry a hash of the
/// content: a mesh file is never changed, scenes may share a folder, and the scene file, written
/// last and atomically, never names a missing mesh.
/// @param scene  its bodies get their `file_name`.
/// @return all files of the scene, the scene file first.
/// @throws Error: BadInput for an unknown extension, Environment if a file cannot be written.
std::vector<std::string> write_simulation(SimulationScene& scene, const std::string& path,
                                          const SimulationFileOptions& options = {});

/// True if write_simulation() supports the extension, such as ".urdf".
bool is_simulation_extension(const std::string& extension);
/// ".xml, .mjcf, ..."
const std::vector<std::string>& simulation_extensions();

/// Characters that names of a format may have.
enum class NameRule {
  Identifier,  // ASCII letters, digits and '_', as prims of USD
  Xml,         // the same, '-', '.', and all printed characters beyond ASCII, as UTF-8
};

/// Makes names by the rule: other characters become '_', and names begin with a letter or '_'; all
/// are different, none is in `taken`. Valid names stay unchanged.
std::vector<std::string> valid_names(const std::vector<std::string>& names, NameRule rule,
                                     std::set<std::string> taken);

}  // namespace trivet
