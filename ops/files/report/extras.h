// Trivet's data in the `extras` of a scene file: all that glTF itself cannot hold.
//
//   scene.extras.trivet: {"trivet": 1, "version", "floor", "floor_material", "clearance",
//     "models":  [{"path", "triangles", "fingerprint", "stored_fingerprint", "centre",
//                  "face_order", "own_nodes",            see geometry.h
//                  "chord", "facet_angle_deg",                 as a layout has them
//                  "mesh",                               see stored_mesh.h; no path: of no file
//                  "collision"}],                        likewise, of what is judged instead
//     "objects": [{"name", "model": index, "up", "scale", "fixed", "state",
//                  "position", "rotation",               no position: out of the scene
//                  "locked", "group", "material", "mass",    if it is, has
//                  "pair_kind",                          of "pair_rules"
//                  "joint",                              see joint_json.h
//                  "flexible"}],                         see flexible_json.h
//     "pair_rules": [{"kinds": [kind, kind], "may_pass", "friction"}], "floor_kind"   if any
//     "load_support": [{"object", "supports", "loads"}], "floor" is the floor
//     "origin": [x, y, z],                              what the nodes' poses are relative to, z
//     up;
//                                                       none: 0
//     "layout":  {...}}                                  as a layout file, of what made the scene
//   node.extras.trivet: the object's entry of a report
//
// Trivet reads back the first only; the second is for other programs. Paths are relative to the
// scene file.
#pragma once

#include <string>
#include <vector>

#include "ops/files/report/geometry.h"
#include "ops/files/report/scene_file.h"

namespace trivet {

std::string scene_extras(const Scene& scene, const Layout& layout, const SceneFileOptions& options);
std::string node_extras(const Scene& scene, const Object& object, const LoadSupport::Entry* entry,
                        const SceneFileOptions& options);

struct ExtrasModel {
  std::string path;
  Tessellation tessellation;  // of a model with curved surfaces
  StoredGeometry geometry;
  std::shared_ptr<const Model> mesh;  // of no file, and not to be had from the scene; else null
  std::shared_ptr<const Model> collision;  // its mesh is judged, the model's is drawn; else null
};

struct ExtrasObject {
  std::string name;
  size_t model = 0;
  UpAxis up = UpAxis::Z;
  double scale = 1;
  bool fixed = false;
  bool locked = false;
  std::string group;
  PhysicsMaterial material;
  std::optional<GivenMass> mass;
  PairKind pair_kind = 0;
  std::optional<NamedJoint> joint;
  std::shared_ptr<const Flexible> flexible;
  ObjectState state = ObjectState::Unplaced;
  std::optional<Pose> pose;
};

struct TrivetExtras {
  bool floor = true;
  PhysicsMaterial floor_material;
  PairKind floor_kind = 0;
  std::shared_ptr<const PairRules> pair_rules;
  double clearance = 0;
  Vec3 origin = Vec3::Zero();
  std::vector<ExtrasModel> models;
  std::vector<ExtrasObject> objects;
  Layout layout;
};

/// @param text  the extras of a scene; empty when it has none.
/// @throws Error (BadInput) naming the file and the place.
TrivetExtras parse_scene_extras(const std::string& text, const std::string& file);
bool has_trivet_extras(const std::string& text);

}  // namespace trivet
