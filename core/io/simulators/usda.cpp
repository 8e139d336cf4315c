// USD as text, with the schemas UsdGeom and UsdPhysics: a stage of bodies that reference separate
// layers, one per model.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <map>

#include "core/io/simulators/looked_files.h"
#include "core/io/simulators/usda_text.h"

namespace trivet {
namespace {

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

void add_body(UsdaText& text, const SimulationBody& body, const std::string& layer,
              const Surfaces& surfaces) {
  const std::string reference = "prepend references = @./" + layer + "@";
  // A collider without a rigid body is static.
  text.open(
      "Xform", body.file_name,
      {body.fixed ? usda_apis({"MaterialBindingAPI"})
                  : usda_apis({"PhysicsRigidBodyAPI", "PhysicsMassAPI", "MaterialBindingAPI"}),
       reference, "displayName = " + usda_quoted(body.name)});
  text.line("custom string trivet:name = " + usda_quoted(body.name));
  text.line(surfaces.binding(body.friction, body.restitution));
  if (!body.fixed) {
    const PrincipalInertia inertia = principal(body.inertia);
    text.line("point3f physics:centerOfMass = " + usda_tuple(body.centre));
    text.line("float3 physics:diagonalInertia = " + usda_tuple(inertia.diagonal));
    text.line("float physics:mass = " + number_text(body.mass));
    text.line("quatf physics:principalAxes = " + usda_tuple(inertia.axes));
    text.line("bool physics:startsAsleep = 1");
  }
  add_transform(text, body.world_from_link);
  text.close();
}

// @param layers  of the models.
std::string world_layer(const SimulationScene& scene, const std::vector<MeshFile>& layers,
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
    text.open("Plane", "floor", {usda_apis({"PhysicsCollisionAPI", "MaterialBindingAPI"})});
    text.line("uniform token axis = \"Z\"");
    text.line("uniform token purpose = \"guide\"");
    text.line(surfaces.binding(scene.floor_friction, scene.floor_restitution));
    text.close();
  }
  for (const SimulationBody& body : scene.bodies)
    add_body(text, body, folder + layers[body.model].name, surfaces);
  text.close();
  return text.take();
}

}  // namespace

SimulationText write_usda(const SimulationScene& scene, const std::string& folder,
                          const SimulationFileOptions&) {
  SimulationText out;
  out.meshes = usda_meshes(scene);
  out.scene = world_layer(scene, out.meshes, folder);
  const ImageFiles images(scene);
  out.meshes.insert(out.meshes.end(), images.files().begin(), images.files().end());
  return out;
}

}  // namespace trivet
