#include "ops/simulation/simulation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <tuple>

#include "core/base/error.h"
#include "core/base/float32.h"
#include "core/base/tunables.h"
#include "core/model/exported_floats.h"
#include "core/scene/friction.h"
#include "ops/files/json/text.h"
#include "ops/files/report/models_of_shapes.h"
#include "ops/simulation/fitted_parts.h"
#include "ops/simulation/joints_of_scene.h"
#include "ops/simulation/loads.h"
#include "ops/simulation/looks.h"
#include "ops/simulation/overlaps.h"
#include "ops/simulation/part_cache.h"
#include "ops/simulation/shells.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

Mesh in_frame(const Mesh& mesh, const Affine& frame_from_object) {
  Mesh out;
  out.triangles = mesh.triangles;
  for (const Vec3& v : mesh.vertices) out.vertices.push_back(frame_from_object.apply(v));
  return out;
}

std::vector<ConvexPart> scaled(std::vector<ConvexPart> parts, double scale) {
  // Scaled vertices are rounded as those that are written: they must not overlap by rounding.
  if (scale == 1) return parts;
  for (ConvexPart& part : parts)
    for (Vec3& v : part.vertices) v = as_float32(Vec3(v * scale));
  return parts;
}

PartRule part_rule(CollisionRule rule) {
  if (rule == CollisionRule::Hull) return PartRule::Hull;
  return rule == CollisionRule::Decomposition ? PartRule::Decomposition : PartRule::Components;
}

// Parts that are turned inside out count with negative masses.
bool is_of_a_body(const Mat3& covariance) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvalues()[0] >= 0;
}

Mat3 nearest_of_a_body(const Mat3& covariance, double least) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
  const Vec3 spread = solver.eigenvalues().cwiseMax(least);
  return solver.eigenvectors() * spread.asDiagonal() * solver.eigenvectors().transpose();
}

constexpr double kVertexRounding = 0x1p-22;  // of a size

class SceneMaker {
 public:
  SceneMaker(const Scene& scene, const std::string& name, const SimulationOptions& options)
      : m_scene(scene), m_options(options) {
    m_out.scene.name = name;
    m_out.scene.floor = scene.floor;
    m_out.scene.floor_friction = options.friction.value_or(scene.floor_material.friction);
    m_out.scene.floor_restitution = scene.floor_material.restitution;
    m_out.scene.gravity = kGravity;
  }

  SimulationExport make() {
    for (const ObjectId id : m_scene.ids())
      if (m_scene.at(id).placed) add(id);
    if (m_options.joints) add_joints();
    m_out.scene.heaviest_load = heaviest_load(m_scene, m_body_of, m_out.scene.bodies);
    if (m_options.collision == CollisionRule::Mesh) return std::move(m_out);
    if (m_options.collision == CollisionRule::Fitted)
      add_fitted_parts();
    else
      add_parts();
    if (m_options.measured) measure_parts();
    m_out.overlaps = part_overlaps(m_out.scene, limit());
    m_out.scene.num_near_parts = num_near_parts(m_out.scene);
    return std::move(m_out);
  }

 private:
  void add(ObjectId id) {
    const Object& object = m_scene.at(id);
    const MassProperties& properties = object.shape->mass;
    SimulationBody body;
    body.name = object.name;
    body.model = model_of(object);
    const Affine& link_from_object = m_out.scene.models[body.model].link_from_object;
    body.world_from_link = object.pose;
    body.world_from_link.translation += object.pose.rotation.matrix() * m_shifts[body.model];
    body.fixed = object.fixed;
    body.mass = weight_of(object, m_options.density.value_or(object.material.density)) / kGravity;
    if (!(body.mass > 0))
      throw Error(Error::Kind::BadInput,
                  "\"%1\" has no size and so no mass; it cannot be simulated", object.name);
    body.centre = link_from_object.apply(properties.centre);
    Mat3 covariance =
        link_from_object.linear * properties.covariance * link_from_object.linear.transpose();
    const double of_wall = wall_thickness(object) * wall_thickness(object) / 12;
    if (properties.rule != MassRule::Volume) covariance += of_wall * Mat3::Identity();
    if (!is_of_a_body(covariance)) {
      covariance = nearest_of_a_body(covariance, of_wall);
      m_out.notes.push_back(say(
          "\"%1\" has parts that are turned inside out: its inertia is that of no body, and the "
          "nearest one is written",
          object.name));
    }
    body.inertia = body.mass * inertia_per_mass(covariance);
    body.friction = m_options.friction.value_or(object.material.friction);
    body.restitution = object.material.restitution;
    body.gap = widest_gap(object);
    m_sizes.push_back(object.scale * object.shape->box.diagonal());
    m_body_of[id] = m_out.scene.bodies.size();
    m_out.scene.bodies.push_back(std::move(body));
    add_notes(id);
  }

  double widest_gap(const Object& object) {
    double widest = 0;
    for (const ObjectContact& entry : object.contacts) {
      double of_entry = 0;
      for (const ContactPoint& p : entry.contact.points) of_entry = std::max(of_entry, p.gap);
      widest = std::max(widest, of_entry);
      double& of_floor = m_out.scene.floor_gap;
      if (entry.with.is_floor()) of_floor = std::max(of_floor, of_entry);
    }
    return widest;
  }

  void add_joints() {
    SimulationJoints made =
        simulation_joints(m_scene, *m_options.joints, m_body_of, m_out.scene.bodies);
    m_out.scene.joints = std::move(made.joints);
    m_out.notes.insert(m_out.notes.end(), made.notes.begin(), made.notes.end());
  }

  void add_notes(ObjectId id) {
    const Object& object = m_scene.at(id);
    if (object.flexible)
      m_out.notes.push_back(
          say("\"%1\" came to rest as it is: here it is fixed and does not bend", object.name));
    if (object.shape->mass.volume == 0 && !object.given_mass && !object.fixed)
      m_out.notes.push_back(say("\"%1\" encloses nothing: it weighs as a sheet of %2 metres, %3 kg",
                                object.name, figure(wall_thickness(object)),
                                figure(m_out.scene.bodies.back().mass)));
    if (object.state != ObjectState::Fixed && object.state != ObjectState::Stable)
      m_out.notes.push_back(
          say("\"%1\" is %2: it will move", object.name, to_string(object.state)));
    // The weakest contact decides: the needed friction is assumed at all of them.
    double friction = kInfinity;
    for (const ObjectContact& entry : object.contacts)
      friction = std::min(friction,
                          m_options.friction.value_or(friction_between(m_scene, id, entry.with)));
    if (!object.fixed && object.least_friction > friction)
      m_out.notes.push_back(say("\"%1\" needs friction %2, its contacts have %3: it will move",
                                object.name, figure(object.least_friction), figure(friction)));
  }

  size_t model_of(const Object& object) {
    const auto key =
        std::make_tuple(object.model.get(), object.shape->index.get(), object.up, object.scale);
    // Objects share a model where shape, up axis and scale are the same.
    const auto [it, is_new] = m_models.try_emplace(key, m_out.scene.models.size());
    if (is_new) add_model(object);
    return it->second;
  }

  static Affine link_axes(const Object& object, double scale) {
    Affine out = world_from_object({}, object.up, scale);
    out.translation = -out.apply(export_centre(object.model.get(), object.shape->box));
    return out;
  }

  void add_model(const Object& object) {
    SimulationModel model;
    const std::string& path = object.model->path;  // scenes of others have none
    model.name = path.empty() ? object.name : std::filesystem::path(path).stem().string();
    model.model = object.model;
    model.scale = m_options.files.for_many_scenes ? object.scale : 1;
    model.link_from_object = link_axes(object, object.scale);
    model.file_from_object = link_axes(object, object.scale / model.scale);
    model.look = simulation_look(object.model);
    if (model.look)
      m_out.notes.insert(m_out.notes.end(), model.look->left_out.begin(),
                         model.look->left_out.end());
    m_shifts.push_back(-model.link_from_object.translation);
    m_shapes.push_back(object.shape.get());
    m_scales.push_back(object.scale);
    m_unscaled.push_back(link_axes(object, 1));
    m_memos.push_back(m_options.cache ? m_options.cache->of(object) : nullptr);
    m_out.scene.models.push_back(std::move(model));
  }

  std::function<double(size_t, size_t)> limit() const {
    return [this](size_t a, size_t b) {
      return m_options.max_overlap > 0 ? m_options.max_overlap
                                       : kMaxPartOverlap * std::min(m_sizes[a], m_sizes[b]);
    };
  }

  // Parts are split until they are apart to within the rounding of their vertices to float32.
  std::function<double(size_t, size_t)> closest_fit() const {
    return [this](size_t a, size_t b) {
      return m_options.max_overlap > 0 ? m_options.max_overlap
                                       : kVertexRounding * (m_sizes[a] + m_sizes[b]);
    };
  }

  /// @param unit  of the parts given, metres.
  void set_parts(SimulationModel& model, std::vector<ConvexPart> parts, double unit) const {
    // The clearance is in units of the part's own frame.
    const double clearance = m_options.hull_clearance / model.scale;
    for (ConvexPart& part : scaled(std::move(parts), unit / model.scale))
      model.parts.push_back(clearance > 0 ? shrunk(part, clearance) : std::move(part));
  }

  // Colliders of scenes of others touch each other, but are one hull each.
  Mesh in_shells(Mesh mesh) const {
    return m_options.joints ? shells_apart(mesh) : std::move(mesh);
  }
  const Adjacency& adjacency_of(size_t model, const Mesh& mesh) {
    if (!m_options.joints) return m_shapes[model]->adjacency;
    return m_of_shells.emplace_back(make_adjacency(mesh));
  }

  void add_parts() {
    for (size_t i = 0; i < m_out.scene.models.size(); ++i) {
      SimulationModel& model = m_out.scene.models[i];
      const Mesh mesh = in_shells(in_frame(m_shapes[i]->mesh, model.link_from_object));
      ConvexParts parts = convex_parts(mesh, adjacency_of(i, mesh), part_rule(m_options.collision));
      for (const Sentence& note : parts.notes)
        m_out.notes.push_back(say("\"%1\": %2", model.model->path, note));
      set_parts(model, std::move(parts.parts), 1);
    }
  }

  void add_fitted_parts() {
    std::vector<SimulationModel>& models = m_out.scene.models;
    // In units of the files: hulls are the same then whatever the scale is.
    std::vector<Mesh> meshes;
    for (size_t i = 0; i < models.size(); ++i)
      meshes.push_back(in_shells(in_frame(m_shapes[i]->mesh, m_unscaled[i])));
    std::vector<HullTree> trees;
    trees.reserve(models.size());
    for (size_t i = 0; i < models.size(); ++i)
      trees.emplace_back(meshes[i], adjacency_of(i, meshes[i]),
                         kWallThickness * meshes[i].box().diagonal(), m_memos[i].get());
    std::vector<FittedBody> bodies;
    for (const SimulationBody& body : m_out.scene.bodies)
      bodies.push_back({body.model,
                        world_from_object(body.world_from_link, UpAxis::Z, m_scales[body.model]),
                        m_scales[body.model], body.fixed});
    if (m_options.max_error > 0) follow_surfaces(meshes, trees);
    fit_parts(trees, bodies, m_out.scene.floor, closest_fit());
    for (size_t i = 0; i < models.size(); ++i) set_parts(models[i], trees[i].parts(), m_scales[i]);
  }

  void follow_surfaces(const std::vector<Mesh>& meshes, std::vector<HullTree>& trees) {
    for (size_t i = 0; i < trees.size(); ++i) {
      const SurfaceProbe surface(meshes[i], m_shapes[i]->adjacency);
      if (follow_surface(trees[i], surface, m_options.max_error / m_scales[i])) continue;
      m_out.notes.push_back(
          say("\"%1\": its parts stand out of its surface by more than %2 metres in places",
              m_out.scene.models[i].model->path, figure(m_options.max_error)));
    }
  }

  void measure_parts() {
    for (size_t i = 0; i < m_out.scene.models.size(); ++i) {
      const SimulationModel& model = m_out.scene.models[i];
      const Mesh mesh = in_frame(m_shapes[i]->mesh, model.file_from_object);
      const SurfaceProbe surface(mesh, m_shapes[i]->adjacency);
      StandsOut farthest;
      for (const ConvexPart& part : model.parts) farthest = surface.farthest(part, farthest);
      m_out.stands_out.push_back({model.scale * farthest.distance, model.scale * farthest.at});
    }
  }

  const Scene& m_scene;
  const SimulationOptions& m_options;
  SimulationExport m_out;
  std::map<ObjectId, size_t, SlotOrder> m_body_of;
  std::map<std::tuple<const Model*, const ShapeIndex*, UpAxis, double>, size_t> m_models;
  std::vector<Vec3> m_shifts;                      // of the models: from the pose to the link frame
  std::vector<const Shape*> m_shapes;              // of the models
  std::vector<std::shared_ptr<HullMemo>> m_memos;  // the same; null without a cache
  std::vector<double> m_scales;                    // of the models, metres per unit
  std::vector<Affine> m_unscaled;                  // of the models: axes of the link, their unit
  std::vector<double> m_sizes;                     // of the bodies
  std::deque<Adjacency> m_of_shells;
};

}  // namespace

SimulationExport simulation_of(const Scene& scene, const std::string& name,
                               const SimulationOptions& options) {
  const WholeModels whole(scene);
  return SceneMaker(whole.scene(), name, options).make();
}

}  // namespace trivet
