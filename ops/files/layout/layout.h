// Layout files: which objects there are, where they stand, and what is done with them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/limits.h"
#include "core/model/tessellation.h"
#include "core/motion/pose.h"
#include "core/scene/given_mass.h"
#include "core/scene/physics_material.h"
#include "ops/base/options.h"
#include "ops/files/json/joint_json.h"
#include "ops/files/json/pair_rule.h"
#include "ops/files/layout/scene_looks.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Rule for which nodes of a glTF scene are objects, each with all below it.
enum class SceneRule {
  Roots,   // those at the top, or in the one node at the top that holds them all
  Groups,  // the first on the way down that has a mesh, or only children with meshes of their own
  Meshes,  // every node with a mesh, its own mesh alone
};

struct LayoutObject {
  std::string name;             // unique, not "floor"; of Layout::scene, if there is one
  std::string model;            // path relative to the layout file; empty: of the scene
  std::optional<double> scale;  // metres per unit of the file; nothing: as it states, else 1
  std::optional<UpAxis> up;     // nothing: as the model's format says, else z
  bool fixed = false;
  std::optional<Pose>
      pose;  // stands there from the start; nothing: out of the scene until it is put
  Tessellation tessellation = {};                // of a model with curved surfaces
  std::optional<PhysicsMaterial> material = {};  // nothing: the layout's
  std::optional<GivenMass> mass = {};            // nothing: density times volume
  std::optional<NamedJoint> joint = {};          // in which it hangs; it is fixed then
  // Path of the model that is judged, in the coordinates of the other, which is drawn; empty: it is
  // judged itself.
  std::string collision = {};
  // For labelled images.
  std::string class_name = {};  // empty: the name of the model's file
  std::string attributes = {};  // text of a JSON object; empty: none
};

struct Layout {
  bool floor = true;
  std::string scene;  // a glTF file whose objects are picked, relative to the layout; empty: none
  SceneRule scene_rule = SceneRule::Roots;
  SettleRules settle;                             // of the operations; stated, they are obeyed
  PhysicsMaterial material;                       // of what has none of its own
  std::optional<PhysicsMaterial> floor_material;  // nothing: the same
  std::vector<NamedPairRule> pairs;
  std::vector<LayoutObject> objects;
  std::vector<Operation> operations;  // on objects of these names
  SceneLooks looks;                   // how editors show the result
  std::string arrange = {};  // text of the section "arrange", which `trivet arrange` and the editor
                             // solve; kept as it is; empty: none
};

/// A quaternion w, x, y, z of any length but zero as a rotation; one of unit length is taken as it
/// is, so that what Trivet writes is read to the same bits. Nothing: no component is of the
/// magnitude kMinQuaternionComponent.
std::optional<Rotation> unit_rotation(const std::array<double, 4>& quaternion);

/// Reads a layout strictly: whatever is not in its schema is an error, and so are names
/// that come twice, keys that come twice and operations on unknown objects, which a schema cannot
/// say. Models are not opened.
/// @param file  name for messages.
/// @throws Error (BadInput) naming the file, the place as a JSON pointer, the value and what is
///   accepted.
Layout parse_layout(const std::string& text, const std::string& file);
Layout read_layout(const std::string& path, std::uintmax_t max_bytes = std::uintmax_t{1} << 30);

/// The layout as JSON text that parse_layout reads to the same bits.
std::string write_layout(const Layout& layout);

}  // namespace trivet
