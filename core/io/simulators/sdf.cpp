// SDFormat 1.9 worlds, for Gazebo and other SDF readers.
#include "core/io/simulators/joints.h"
#include "core/io/simulators/simulation_files.h"

namespace trivet {
namespace {

using Element = tinyxml2::XMLElement;

std::string pose_text(const Vec3& p, const Rotation& r) {
  return numbers_text({p.x(), p.y(), p.z(), r.x, r.y, r.z, r.w});
}

// Gazebo's engines take the smaller coefficient of two.
void add_surface(Element* collision, double friction, double restitution) {
  Element* const surface = add_child(collision, "surface");
  if (restitution > 0)
    add_text(add_child(surface, "bounce"), "restitution_coefficient", number_text(restitution));
  Element* const both = add_child(surface, "friction");
  Element* const ode = add_child(both, "ode");  // Gazebo's DART reads this one too
  Element* const bullet = add_child(both, "bullet");
  add_text(ode, "mu", number_text(friction));
  add_text(ode, "mu2", number_text(friction));
  add_text(bullet, "friction", number_text(friction));
  add_text(bullet, "friction2", number_text(friction));
}

void add_mesh_shape(Element* parent, const std::string& uri, double scale) {
  Element* const mesh = add_child(add_child(parent, "geometry"), "mesh");
  add_text(mesh, "uri", uri);
  if (scale != 1) add_text(mesh, "scale", numbers_text({scale, scale, scale}));
}

void add_inertia(Element* link, const SimulationBody& body) {
  Element* const inertial = add_child(link, "inertial");
  add_text(inertial, "pose", vector_text(body.centre) + " 0 0 0");
  add_text(inertial, "mass", number_text(body.mass));
  Element* const inertia = add_child(inertial, "inertia");
  const Mat3& i = body.inertia;
  add_text(inertia, "ixx", number_text(i(0, 0)));
  add_text(inertia, "ixy", number_text(i(0, 1)));
  add_text(inertia, "ixz", number_text(i(0, 2)));
  add_text(inertia, "iyy", number_text(i(1, 1)));
  add_text(inertia, "iyz", number_text(i(1, 2)));
  add_text(inertia, "izz", number_text(i(2, 2)));
}

void add_ground(Element* world, const SimulationScene& scene) {
  Element* const model = add_child(world, "model", {{"name", "floor"}});
  add_text(model, "static", "true");
  Element* const link = add_child(model, "link", {{"name", "link"}});
  for (const char* tag : {"collision", "visual"}) {
    Element* const shape = add_child(link, tag, {{"name", tag}});
    Element* const plane = add_child(add_child(shape, "geometry"), "plane");
    add_text(plane, "normal", "0 0 1");
    add_text(plane, "size", "100 100");
    if (std::string(tag) == "collision")
      add_surface(shape, scene.floor_friction, scene.floor_restitution);
  }
}

/// Links, the first of a model named "link".
void add_link(Element* model, const std::string& name, const Pose* in_model,
              const SimulationBody& body, const ModelFiles& files, const std::string& folder) {
  Element* const link = add_child(model, "link", {{"name", name}});
  if (in_model)
    add_text(link, "pose", pose_text(in_model->translation, in_model->rotation))
        ->SetAttribute("rotation_format", "quat_xyzw");
  add_inertia(link, body);
  int count = 0;
  for (const std::string& part : files.parts) {
    Element* const collision =
        add_child(link, "collision", {{"name", "collision_" + std::to_string(count++)}});
    add_mesh_shape(collision, folder + part, files.scale);
    add_surface(collision, body.friction, body.restitution);
  }
  Element* const visual = add_child(link, "visual", {{"name", "visual"}});
  add_mesh_shape(visual, folder + files.whole, files.scale);
}

// Limits count from where the link is: SDF has no other values.
void add_axis(Element* element, const SimulationJoint& joint) {
  add_text(element, "pose", vector_text(joint.anchor) + " 0 0 0");
  Element* const axis = add_child(element, "axis");
  add_text(axis, "xyz", vector_text(joint.axis));
  Element* const limit = add_child(axis, "limit");
  if (joint.lower > -kInfinity) add_text(limit, "lower", number_text(joint.lower - joint.value));
  if (joint.upper < kInfinity) add_text(limit, "upper", number_text(joint.upper - joint.value));
  if (joint.friction > 0)
    add_text(add_child(axis, "dynamics"), "friction", number_text(joint.friction));
}

void add_joint(Element* model, const std::string& name, const std::string& type,
               const std::string& parent, const std::string& child, const SimulationJoint* joint) {
  Element* const element = add_child(model, "joint", {{"name", name}, {"type", type}});
  add_text(element, "parent", parent);
  add_text(element, "child", child);
  if (joint && joint->kind != SimulationJoint::Kind::Fixed) add_axis(element, *joint);
}

/// A model of several links.
void add_tree(Element* world, const SimulationScene& scene, const JointsOfBodies& joints,
              size_t root, const MeshFiles& meshes, const std::string& folder) {
  const SimulationBody& first = scene.bodies[root];
  Element* const model = add_child(world, "model", {{"name", first.file_name}});
  add_text(model, "pose",
           pose_text(first.world_from_link.translation, first.world_from_link.rotation))
      ->SetAttribute("rotation_format", "quat_xyzw");
  const auto name = [&](size_t body) {
    return body == root ? std::string("link") : scene.bodies[body].file_name;
  };
  for (const size_t i : joints.tree(root)) {
    const SimulationBody& body = scene.bodies[i];
    const Pose pose = relative_pose(first.world_from_link, body.world_from_link);
    add_link(model, name(i), i == root ? nullptr : &pose, body, meshes.of_model(body.model),
             folder);
    const SimulationJoint* const joint = joints.of(i);
    if (!joint) {
      add_joint(model, "to_the_world", "fixed", "world", name(i), nullptr);
      continue;
    }
    const char* const type = joint->kind == SimulationJoint::Kind::Fixed   ? "fixed"
                             : joint->kind == SimulationJoint::Kind::Slide ? "prismatic"
                                                                           : "revolute";
    add_joint(model, joint->file_name, type, joint->parent ? name(*joint->parent) : "world",
              name(i), joint);
  }
}

void add_model(Element* world, const SimulationBody& body, const ModelFiles& files,
               const std::string& folder) {
  Element* const model = add_child(world, "model", {{"name", body.file_name}});
  Element* const pose = add_text(
      model, "pose", pose_text(body.world_from_link.translation, body.world_from_link.rotation));
  pose->SetAttribute("rotation_format", "quat_xyzw");
  add_text(model, "static", body.fixed ? "true" : "false");
  add_text(model, "allow_auto_disable", "true");  // may sleep: at rest
  add_link(model, "link", nullptr, body, files, folder);
}

}  // namespace

SimulationText write_sdf(const SimulationScene& scene, const std::string& folder,
                         const SimulationFileOptions& options) {
  const MeshFiles meshes(scene, false);
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  document.InsertEndChild(document.NewComment(kMadeBy));
  Element* const root = add_child(&document, "sdf", {{"version", "1.9"}});
  Element* const world = add_child(root, "world", {{"name", scene.name}});
  add_text(world, "gravity", "0 0 " + number_text(-scene.gravity));
  Element* const light = add_child(world, "light", {{"name", "sun"}, {"type", "directional"}});
  add_text(light, "pose", "0 0 10 0 0 0");
  add_text(light, "direction", "-0.3 0.2 -0.9");
  if (scene.floor) add_ground(world, scene);
  const JointsOfBodies joints(scene);
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const SimulationBody& body = scene.bodies[i];
    const SimulationJoint* const joint = joints.of(i);
    if (joint && joint->parent) continue;
    if (joint || !joints.below(i).empty())
      add_tree(world, scene, joints, i, meshes, options.mesh_prefix + folder);
    else
      add_model(world, body, meshes.of_model(body.model), options.mesh_prefix + folder);
  }
  return {meshes.files(), xml_text(document)};
}

}  // namespace trivet
