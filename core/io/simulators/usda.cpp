// USD as text, with the schemas UsdGeom and UsdPhysics: a stage of bodies that reference separate
// layers, one per model, and one per convex part where many scenes share them.
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
std::vector<std::string> body_metadata(const SimulationBody& body) {
  return {body.fixed ? usda_apis({"MaterialBindingAPI"})
                     : usda_apis({"PhysicsRigidBodyAPI", "PhysicsMassAPI", "MaterialBindingAPI"}),
          "displayName = " + usda_quoted(body.name)};
}

/// Opens it.
void add_body(UsdaText& text, const SimulationBody& body, const std::vector<std::string>& metadata,
              const Surfaces& surfaces) {
  text.open("Xform", body.file_name, metadata);
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
    text.open("Plane", "floor", {usda_apis({"PhysicsCollisionAPI", "MaterialBindingAPI"})});
    text.line("uniform token axis = \"Z\"");
    text.line("uniform token purpose = \"guide\"");
    text.line(surfaces.binding(scene.floor_friction, scene.floor_restitution));
    text.close();
  }
  for (const SimulationBody& body : scene.bodies) {
    const UsdaLayers::OfModel& of_model = layers.of_model[body.model];
    std::vector<std::string> metadata = body_metadata(body);
    if (!parts_apart) metadata.insert(metadata.begin() + 1, reference_to(folder + of_model.file));
    add_body(text, body, metadata, surfaces);
    if (parts_apart) add_shape(text, of_model, scene.models[body.model].scale, folder);
    text.close();
  }
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
