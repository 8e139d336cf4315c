#include "ops/simulation/simulation.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/tunables.h"
#include "core/convex/hull_overlap.h"
#include "core/io/mesh/float_export.h"
#include "ops/files/report/models_of_shapes.h"
#include "ops/simulation/overlaps.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

/// A quarter more than what is needed: simulators' contacts are soft.
constexpr double kFrictionReserve = 1.25;

Mesh in_frame(const Mesh& mesh, const Affine& frame_from_object) {
  Mesh out;
  out.triangles = mesh.triangles;
  for (const Vec3& v : mesh.vertices) out.vertices.push_back(frame_from_object.apply(v));
  return out;
}

PartRule part_rule(CollisionRule rule) {
  if (rule == CollisionRule::Hull) return PartRule::Hull;
  return rule == CollisionRule::Decomposition ? PartRule::Decomposition : PartRule::Components;
}

class SceneMaker {
 public:
  SceneMaker(const Scene& scene, const std::string& name, const SimulationOptions& options)
      : m_scene(scene), m_options(options), m_frictions(frictions_of(scene, options.friction)) {
    m_out.scene.name = name;
    m_out.scene.floor = scene.floor;
    m_out.scene.floor_friction = options.friction;
    m_out.scene.gravity = kGravity;
  }

  SimulationExport make() {
    for (const ObjectId id : m_scene.ids())
      if (m_scene.at(id).placed) add(id);
    if (m_out.scene.floor)  // carries what needs most
      for (const SimulationBody& body : m_out.scene.bodies)
        m_out.scene.floor_friction = std::max(m_out.scene.floor_friction, body.friction);
    if (m_options.collision != CollisionRule::Mesh) m_out.overlaps = part_overlaps(m_out.scene);
    return std::move(m_out);
  }

 private:
  /// Enough for the object and for what lies on it.
  static std::map<std::uint32_t, double> frictions_of(const Scene& scene, double friction) {
    std::map<std::uint32_t, double> out;
    const auto need = [&](ObjectId id) {
      const Object& object = scene.at(id);
      const double least = object.fixed ? 0 : kFrictionReserve * object.least_friction;
      return least < kInfinity ? std::max(least, friction) : friction;
    };
    for (const LoadSupport::Entry& entry : load_support(scene).entries) {
      double& of_object = out[entry.object.index] = need(entry.object);
      for (const ObjectId load : entry.loads) of_object = std::max(of_object, need(load));
    }
    return out;
  }

  void add(ObjectId id) {
    const Object& object = m_scene.at(id);
    const MassProperties& properties = object.shape->mass;
    SimulationBody body;
    body.name = object.name;
    body.model = model_of(object);
    const Affine& link_from_object = m_out.scene.models[body.model].link_from_object;
    body.world_from_link = object.pose;
    body.world_from_link.translation += object.pose.rotation.matrix() * shift_of(body.model);
    body.fixed = object.fixed;
    body.mass = weight_of(object, m_options.density) / kGravity;
    if (!(body.mass > 0))
      throw Error(Error::Kind::BadInput,
                  "\"" + object.name + "\" has no size and so no mass; it cannot be simulated");
    body.centre = link_from_object.apply(properties.centre);
    Mat3 covariance =
        link_from_object.linear * properties.covariance * link_from_object.linear.transpose();
    if (properties.rule != MassRule::Volume) {  // the wall that gives it weight
      const double wall = kWallThickness * object.scale * object.shape->box.diagonal();
      covariance += wall * wall / 12 * Mat3::Identity();
    }
    body.inertia = body.mass * inertia_per_mass(covariance);
    const auto friction = m_frictions.find(id.index);
    body.friction = friction == m_frictions.end() ? m_options.friction : friction->second;
    if (object.state != ObjectState::Fixed && object.state != ObjectState::Stable)
      m_out.notes.push_back("\"" + object.name + "\" is " + to_string(object.state) +
                            ": it will move");
    m_out.scene.bodies.push_back(std::move(body));
  }

  size_t model_of(const Object& object) {
    const auto key = std::make_tuple(object.model.get(), object.up, object.scale);
    const auto [it, is_new] = m_models.try_emplace(key, m_out.scene.models.size());
    if (is_new) add_model(object);
    return it->second;
  }

  void add_model(const Object& object) {
    SimulationModel model;
    model.name = std::filesystem::path(object.model->path).stem().string();
    model.model = object.model;
    model.link_from_object = world_from_object({}, object.up, object.scale);
    const Vec3 shift =
        model.link_from_object.apply(export_centre(object.model.get(), object.shape->box));
    model.link_from_object.translation = -shift;
    m_shifts.push_back(shift);
    if (m_options.collision != CollisionRule::Mesh) {
      ConvexParts parts = convex_parts(in_frame(object.shape->mesh, model.link_from_object),
                                       object.shape->adjacency, part_rule(m_options.collision));
      for (const std::string& note : parts.notes)
        m_out.notes.push_back("\"" + object.model->path + "\": " + note);
      for (ConvexPart& part : parts.parts)
        model.parts.push_back(m_options.hull_clearance > 0 ? shrunk(part, m_options.hull_clearance)
                                                           : std::move(part));
    }
    m_out.scene.models.push_back(std::move(model));
  }

  const Vec3& shift_of(size_t model) const { return m_shifts[model]; }

  const Scene& m_scene;
  const SimulationOptions& m_options;
  const std::map<std::uint32_t, double> m_frictions;
  SimulationExport m_out;
  std::map<std::tuple<const Model*, UpAxis, double>, size_t> m_models;
  std::vector<Vec3> m_shifts;  // of the models: from the pose to the link frame
};

}  // namespace

const std::vector<std::string>& collision_rule_names() {
  static const std::vector<std::string> names = {"hull", "components", "decomposition", "mesh"};
  return names;
}

const char* to_string(CollisionRule rule) {
  return collision_rule_names()[static_cast<size_t>(rule)].c_str();
}

CollisionRule collision_rule_from_name(const std::string& name) {
  const std::vector<std::string>& names = collision_rule_names();
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end())
    throw Error(
        Error::Kind::BadInput,
        "\"" + name + "\" is not accepted; accepted: hull, components, decomposition, mesh");
  return static_cast<CollisionRule>(it - names.begin());
}

void check_collision_rule(CollisionRule rule, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (rule == CollisionRule::Mesh && (extension == ".xml" || extension == ".mjcf"))
    throw Error(Error::Kind::BadInput,
                "--collision: \"mesh\" is not accepted for MJCF, as MuJoCo takes the hulls of "
                "meshes; accepted: hull, components, decomposition");
  if (rule == CollisionRule::Decomposition && !can_decompose())
    throw Error(Error::Kind::BadInput,
                "--collision: \"decomposition\" is not part of this build (Debian: "
                "libbullet-extras-dev); accepted: hull, components, mesh");
}

SimulationExport simulation_of(const Scene& scene, const std::string& name,
                               const SimulationOptions& options) {
  const WholeModels whole(scene);
  return SceneMaker(whole.scene(), name, options).make();
}

SimulationExport export_simulation(const Scene& scene, const std::string& path,
                                   const SimulationOptions& options) {
  check_collision_rule(options.collision, path);
  SimulationExport out = simulation_of(scene, std::filesystem::path(path).stem().string(), options);
  out.files = write_simulation(out.scene, path, options.files);
  return out;
}

}  // namespace trivet
