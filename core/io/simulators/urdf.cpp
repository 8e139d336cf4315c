// URDF: a robot with root link "world" and a child link for each object, attached by a fixed joint
// or, if the object is free, a floating one.
#include <algorithm>
#include <cmath>

#include "core/base/hash.h"
#include "core/io/simulators/joints.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {
namespace {

using Element = tinyxml2::XMLElement;

constexpr double kOnAxis = 1e-9;                                    // metres
constexpr const char *kMostEffort = "1000", *kMostVelocity = "10";  // URDF wants some
constexpr double kFloorSize = 100, kFloorThickness = 1;             // metres; URDF has no planes

/// Roll, pitch and yaw about fixed x, y, z: URDF's only form of rotation. Digits beyond the 15th
/// may differ between C libraries.
Vec3 rpy_of(const Rotation& rotation) {
  const Mat3 m = rotation.matrix();
  const double across = std::hypot(m(0, 0), m(1, 0));
  const double pitch = std::atan2(-m(2, 0), across);
  if (across < 1e-9) return {0, pitch, std::atan2(-m(0, 1), m(1, 1))};
  return {std::atan2(m(2, 1), m(2, 2)), pitch, std::atan2(m(1, 0), m(0, 0))};
}

void add_origin(Element* parent, const Vec3& xyz, const Vec3& rpy) {
  add_child(parent, "origin", {{"xyz", vector_text(xyz)}, {"rpy", vector_text(rpy)}});
}

void add_mesh(Element* parent, const std::string& uri, double scale) {
  Element* const mesh = add_child(add_child(parent, "geometry"), "mesh", {{"filename", uri}});
  if (scale != 1) mesh->SetAttribute("scale", numbers_text({scale, scale, scale}).c_str());
}

void add_inertial(Element* link, const SimulationBody& body) {
  Element* const inertial = add_child(link, "inertial");
  add_origin(inertial, body.centre, Vec3::Zero());
  add_child(inertial, "mass", {{"value", number_text(body.mass)}});
  const Mat3& i = body.inertia;
  add_child(inertial, "inertia",
            {{"ixx", number_text(i(0, 0))},
             {"ixy", number_text(i(0, 1))},
             {"ixz", number_text(i(0, 2))},
             {"iyy", number_text(i(1, 1))},
             {"iyz", number_text(i(1, 2))},
             {"izz", number_text(i(2, 2))}});
}

/// Friction in the extensions of Bullet and Gazebo; URDF itself has none.
void add_friction(Element* robot, Element* link, const std::string& name, double friction) {
  const std::string mu = number_text(friction);
  add_child(add_child(link, "contact"), "lateral_friction", {{"value", mu}});
  Element* const gazebo = add_child(robot, "gazebo", {{"reference", name}});
  add_text(gazebo, "mu1", mu);
  add_text(gazebo, "mu2", mu);
}

void add_joint(Element* robot, const std::string& child, bool fixed, const Pose& pose) {
  Element* const joint = add_child(
      robot, "joint", {{"name", child + "_joint"}, {"type", fixed ? "fixed" : "floating"}});
  add_child(joint, "parent", {{"link", "world"}});
  add_child(joint, "child", {{"link", child}});
  add_origin(joint, pose.translation, rpy_of(pose.rotation));
}

std::string name_of_hinge(const SimulationScene& scene, const SimulationBody& child) {
  std::string out = child.file_name + "_hinge";
  while (std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&](const SimulationBody& body) { return body.file_name == out; }))
    out += "_";
  return out;
}

// Limits count from where the link is: URDF has no other values. An axis goes through the origin of
// the link; where it does not, an empty link is between.
void add_joint(Element* robot, const SimulationScene& scene, const SimulationJoint& joint) {
  using Kind = SimulationJoint::Kind;
  const SimulationBody& child = scene.bodies[joint.child];
  const bool unlimited = joint.lower == -kInfinity && joint.upper == kInfinity;
  const std::string type = joint.kind == Kind::Fixed   ? "fixed"
                           : joint.kind == Kind::Slide ? "prismatic"
                           : unlimited                 ? "continuous"
                                                       : "revolute";
  Pose pose = child.world_from_link;
  if (joint.parent) pose = relative_pose(scene.bodies[*joint.parent].world_from_link, pose);
  const bool apart = joint.kind == Kind::Hinge && !joint.anchor.isZero(kOnAxis);
  const std::string link = apart ? name_of_hinge(scene, child) : child.file_name;
  if (apart) {
    pose.translation += pose.rotation.matrix() * joint.anchor;
    add_child(robot, "link", {{"name", link}});
    Element* const rest =
        add_child(robot, "joint", {{"name", child.file_name + "_joint"}, {"type", "fixed"}});
    add_child(rest, "parent", {{"link", link}});
    add_child(rest, "child", {{"link", child.file_name}});
    add_origin(rest, -joint.anchor, Vec3::Zero());
  }
  Element* const element = add_child(robot, "joint", {{"name", joint.file_name}, {"type", type}});
  add_child(element, "parent",
            {{"link", joint.parent ? scene.bodies[*joint.parent].file_name : "world"}});
  add_child(element, "child", {{"link", link}});
  add_origin(element, pose.translation, rpy_of(pose.rotation));
  if (joint.kind == Kind::Fixed) return;
  add_child(element, "axis", {{"xyz", vector_text(joint.axis)}});
  Element* const limit =
      add_child(element, "limit", {{"effort", kMostEffort}, {"velocity", kMostVelocity}});
  if (!unlimited || joint.kind == Kind::Slide) {
    limit->SetAttribute("lower", number_text(finite_limit(joint.lower - joint.value)).c_str());
    limit->SetAttribute("upper", number_text(finite_limit(joint.upper - joint.value)).c_str());
  }
  if (joint.friction > 0)
    add_child(element, "dynamics", {{"friction", number_text(joint.friction)}});
}

void add_floor(Element* robot, double friction) {
  Element* const link = add_child(robot, "link", {{"name", "floor"}});
  for (const char* tag : {"visual", "collision"})
    add_child(add_child(add_child(link, tag), "geometry"), "box",
              {{"size", numbers_text({kFloorSize, kFloorSize, kFloorThickness})}});
  add_friction(robot, link, "floor", friction);
  add_joint(robot, "floor", true, {{}, Vec3(0, 0, -kFloorThickness / 2)});
}

void add_body(Element* robot, const SimulationBody& body, const ModelFiles& files,
              const std::string& folder) {
  Element* const link = add_child(robot, "link", {{"name", body.file_name}});
  add_inertial(link, body);
  add_mesh(add_child(link, "visual"), folder + files.whole, files.scale);
  for (const std::string& part : files.parts)
    add_mesh(add_child(link, "collision"), folder + part, files.scale);
  add_friction(robot, link, body.file_name, body.friction);
}

Element* add_robot(tinyxml2::XMLDocument& document, const std::string& name) {
  document.InsertEndChild(document.NewDeclaration());
  document.InsertEndChild(document.NewComment(kMadeBy));
  return add_child(&document, "robot", {{"name", name}});
}

/// A body and what hangs in it, without the world: its frame is where a program places it.
MeshFile own_file(const SimulationScene& scene, size_t body, const JointsOfBodies& joints,
                  const MeshFiles& meshes, const std::string& folder) {
  tinyxml2::XMLDocument document;
  const std::string& name = scene.bodies[body].file_name;
  Element* const robot = add_robot(document, name);
  for (const size_t i : joints.tree(body)) {
    add_body(robot, scene.bodies[i], meshes.of_model(scene.bodies[i].model), folder);
    if (i != body) add_joint(robot, scene, *joints.of(i));
  }
  std::string text = xml_text(document);
  const std::string file = name + "_" + Hash().add(text).text() + ".urdf";
  return {file, std::move(text)};
}

void add_own_files(SimulationText& out, const SimulationScene& scene, const JointsOfBodies& joints,
                   const MeshFiles& meshes, const std::string& folder) {
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    std::string& name = out.of_bodies.emplace_back();
    if (joints.of(i) && joints.of(i)->parent) continue;
    out.meshes.push_back(own_file(scene, i, joints, meshes, folder));
    name = out.meshes.back().name;
  }
}

}  // namespace

SimulationText write_urdf(const SimulationScene& scene, const std::string& folder,
                          const SimulationFileOptions& options) {
  const MeshFiles meshes(scene, false);
  tinyxml2::XMLDocument document;
  Element* const robot = add_robot(document, scene.name);
  add_child(robot, "link", {{"name", "world"}});
  if (scene.floor) add_floor(robot, scene.floor_friction);
  const JointsOfBodies joints(scene);
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const SimulationBody& body = scene.bodies[i];
    add_body(robot, body, meshes.of_model(body.model), options.mesh_prefix + folder);
    if (const SimulationJoint* const joint = joints.of(i))
      add_joint(robot, scene, *joint);
    else
      add_joint(robot, body.file_name, body.fixed, body.world_from_link);
  }
  SimulationText out{meshes.files(), xml_text(document)};
  const bool prefixed = !options.mesh_prefix.empty();
  if (options.per_object)
    add_own_files(out, scene, joints, meshes, prefixed ? options.mesh_prefix + folder : "");
  return out;
}

}  // namespace trivet
