// USD as text, with the schemas UsdGeom and UsdPhysics: a stage of bodies that reference separate
// layers, one per model, and one per convex part where many scenes share them.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <map>
#include <numbers>

#include "core/io/foreign/scene.h"
#include "core/io/simulators/joints.h"
#include "core/io/simulators/looked_files.h"
#include "core/io/simulators/usda_text.h"

namespace trivet {
namespace {

constexpr double kUsdDegrees = 180 / std::numbers::pi;

struct PrincipalInertia {
  Vec3 diagonal;
  Rotation axes;
};

PrincipalInertia principal(const Mat3& inertia) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
  Mat3 axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return {solver.eigenvalues(), Rotation::from_matrix(axes)};
}

void add_transform(UsdaText& text, const Pose& pose) {
  text.line("quatd xformOp:orient = " + usda_tuple(pose.rotation));
  text.line("double3 xformOp:translate = " + usda_tuple(pose.translation));
  text.line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
}

/// One physical material for each pair of friction and restitution. Of two surfaces PhysX shall
/// take the smaller coefficient of friction, not their mean.
class Surfaces {
 public:
  explicit Surfaces(const SimulationScene& scene) {
    if (scene.floor) add(scene.floor_friction, scene.floor_restitution);
    for (const SimulationBody& body : scene.bodies) add(body.friction, body.restitution);
  }
  std::string binding(double friction, double restitution) const {
    return "rel material:binding:physics = </World/Looks/" + m_names.at({friction, restitution}) +
           ">";
  }
  void write(UsdaText& text) const {
    text.open("Scope", "Looks");
    for (const auto& [surface, name] : m_names) {
      text.open("Material", name, {usda_apis({"PhysicsMaterialAPI", "PhysxMaterialAPI"})});
      text.line("float physics:dynamicFriction = " + number_text(surface.first));
      text.line("float physics:restitution = " + number_text(surface.second));
      text.line("float physics:staticFriction = " + number_text(surface.first));
      text.line("uniform token physxMaterial:frictionCombineMode = \"min\"");
      text.close();
    }
    text.close();
  }

 private:
  void add(double friction, double restitution) {
    m_names.try_emplace({friction, restitution}, "Surface" + std::to_string(m_names.size()));
  }
  std::map<std::pair<double, double>, std::string> m_names;
};

std::string reference_to(const std::string& layer) {
  return "prepend references = @./" + layer + "@";
}

/// Layers of many scenes: below the body, whose mass and inertia no scale shall touch.
void add_shape(UsdaText& text, const UsdaLayers::OfModel& layers, double scale,
               const std::string& folder) {
  text.open("Xform", "Shape", {reference_to(folder + layers.file)});
  text.line("double3 xformOp:scale = " + usda_tuple({scale, scale, scale}));
  text.line("uniform token[] xformOpOrder = [\"xformOp:scale\"]");
  for (size_t i = 0; i < layers.parts.size(); ++i) {
    text.open("", "part" + std::to_string(i), {reference_to(folder + layers.parts[i])});
    text.close();
  }
  text.close();
}

// A collider without a rigid body is static.
std::vector<std::string> body_metadata(const SimulationBody& body, const SimulationJoint* joint) {
  std::string apis = usda_apis({"PhysicsRigidBodyAPI", "PhysicsMassAPI", "MaterialBindingAPI"});
  if (joint)
    apis = usda_apis(
        {"PhysicsRigidBodyAPI", "PhysicsMassAPI", "PhysicsFilteredPairsAPI", "MaterialBindingAPI"});
  else if (body.fixed)
    apis = usda_apis({"MaterialBindingAPI"});
  return {apis, "displayName = " + usda_quoted(body.name)};
}

std::string usda_path(const SimulationBody& body) { return "</World/" + body.file_name + ">"; }

void add_group(UsdaText& text, const std::string& name, const std::string& paths) {
  text.open("PhysicsCollisionGroup", name, {usda_apis({"CollectionAPI:colliders"})});
  if (!paths.empty()) text.line("rel collection:colliders:includes = [" + paths + "]");
  text.close();
}

/// Groups of what stands fixed and of what moves, for robots that shall pass through either: they
/// collide with each other.
void add_groups(UsdaText& text, const SimulationScene& scene, const JointsOfBodies& joints) {
  std::string fixed = scene.floor ? "</World/floor>" : "", moving;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    std::string& paths = scene.bodies[i].fixed && !joints.of(i) ? fixed : moving;
    paths += (paths.empty() ? "" : ", ") + usda_path(scene.bodies[i]);
  }
  text.open("Scope", "Groups");
  add_group(text, "Fixed", fixed);
  add_group(text, "Moving", moving);
  text.close();
}

void add_filtered(UsdaText& text, const SimulationScene& scene, const SimulationJoint& joint) {
  std::string paths;
  for (const size_t other : joint.apart)
    paths += (paths.empty() ? "" : ", ") + usda_path(scene.bodies[other]);
  if (!paths.empty()) text.line("rel physics:filteredPairs = [" + paths + "]");
}

/// A frame at the joint, its x axis along the joint's.
void add_frame(UsdaText& text, const char* number, const Pose& frame) {
  text.line(std::string("point3f physics:localPos") + number + " = " +
            usda_tuple(frame.translation));
  text.line(std::string("quatf physics:localRot") + number + " = " + usda_tuple(frame.rotation));
}

// By how much the value has moved the joint's frame, in that.
Pose moved_frame(const SimulationJoint& joint) {
  if (joint.kind == SimulationJoint::Kind::Slide) return {{}, Vec3(joint.value, 0, 0)};
  if (joint.kind == SimulationJoint::Kind::Hinge)
    return {turn_about(Vec3::UnitX(), joint.value * kUsdDegrees).normalized(), Vec3::Zero()};
  return {};
}

void add_joint(UsdaText& text, const SimulationScene& scene, const SimulationJoint& joint) {
  using Kind = SimulationJoint::Kind;
  const bool turns = joint.kind == Kind::Hinge;
  text.open(joint.kind == Kind::Fixed ? "PhysicsFixedJoint"
            : turns                   ? "PhysicsRevoluteJoint"
                                      : "PhysicsPrismaticJoint",
            joint.file_name, {"displayName = " + usda_quoted(joint.name)});
  const Pose& child = scene.bodies[joint.child].world_from_link;
  const Pose on_child{x_to(joint.axis), joint.anchor};
  Pose on_parent = composed(composed(child, on_child), inverse(moved_frame(joint)));
  if (joint.parent) {
    text.line("rel physics:body0 = " + usda_path(scene.bodies[*joint.parent]));
    on_parent = relative_pose(scene.bodies[*joint.parent].world_from_link, on_parent);
  }
  text.line("rel physics:body1 = " + usda_path(scene.bodies[joint.child]));
  add_frame(text, "0", {on_parent.rotation.normalized(), on_parent.translation});
  add_frame(text, "1", on_child);
  if (joint.kind != Kind::Fixed) {
    const double unit = turns ? kUsdDegrees : 1;
    text.line("uniform token physics:axis = \"X\"");
    if (joint.lower > -kInfinity)
      text.line("float physics:lowerLimit = " + number_text(unit * joint.lower));
    if (joint.upper < kInfinity)
      text.line("float physics:upperLimit = " + number_text(unit * joint.upper));
  }
  text.close();
}

/// Opens it.
void add_body(UsdaText& text, const SimulationBody& body, const std::vector<std::string>& metadata,
              const Surfaces& surfaces, bool moves) {
  text.open("Xform", body.file_name, metadata);
  text.line("custom string trivet:name = " + usda_quoted(body.name));
  text.line(surfaces.binding(body.friction, body.restitution));
  if (moves) {
    const PrincipalInertia inertia = principal(body.inertia);
    text.line("point3f physics:centerOfMass = " + usda_tuple(body.centre));
    text.line("float3 physics:diagonalInertia = " + usda_tuple(inertia.diagonal));
    text.line("float physics:mass = " + number_text(body.mass));
    text.line("quatf physics:principalAxes = " + usda_tuple(inertia.axes));
    text.line("bool physics:startsAsleep = 1");
  }
  add_transform(text, body.world_from_link);
}

std::string world_layer(const SimulationScene& scene, const UsdaLayers& layers, bool parts_apart,
                        const std::string& folder) {
  const Surfaces surfaces(scene);
  UsdaText text("World");
  text.open("Xform", "World");
  text.open("PhysicsScene", "PhysicsScene");
  text.line("vector3f physics:gravityDirection = (0, 0, -1)");
  text.line("float physics:gravityMagnitude = " + number_text(scene.gravity));
  text.close();
  surfaces.write(text);
  if (scene.floor) {
    text.open("Plane", "floor",
              {usda_apis({"PhysicsCollisionAPI", "NewtonCollisionAPI", "MjcCollisionAPI",
                          "MaterialBindingAPI"})});
    add_mujoco_contacts(text);
    text.line("uniform token axis = \"Z\"");
    text.line("uniform token purpose = \"guide\"");
    text.line(surfaces.binding(scene.floor_friction, scene.floor_restitution));
    text.close();
  }
  const JointsOfBodies joints(scene);
  add_groups(text, scene, joints);
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const SimulationBody& body = scene.bodies[i];
    const SimulationJoint* const joint = joints.of(i);
    const UsdaLayers::OfModel& of_model = layers.of_model[body.model];
    std::vector<std::string> metadata = body_metadata(body, joint);
    if (!parts_apart) metadata.insert(metadata.begin() + 1, reference_to(folder + of_model.file));
    add_body(text, body, metadata, surfaces, joint || !body.fixed);
    if (joint) add_filtered(text, scene, *joint);
    if (parts_apart) add_shape(text, of_model, scene.models[body.model].scale, folder);
    text.close();
  }
  for (const SimulationJoint& joint : scene.joints) add_joint(text, scene, joint);
  text.close();
  return text.take();
}

}  // namespace

SimulationText write_usda(const SimulationScene& scene, const std::string& folder,
                          const SimulationFileOptions& options) {
  UsdaLayers layers = usda_layers(scene, options.for_many_scenes);
  SimulationText out;
  out.scene = world_layer(scene, layers, options.for_many_scenes, folder);
  out.meshes = std::move(layers.files);
  const ImageFiles images(scene);
  out.meshes.insert(out.meshes.end(), images.files().begin(), images.files().end());
  return out;
}

}  // namespace trivet
