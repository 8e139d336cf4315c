#include "ops/files/foreign/judged_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/bad_input.h"
#include "core/base/limits.h"
#include "core/io/foreign/primitives.h"
#include "core/io/mesh_model.h"
#include "core/model/model.h"
#include "ops/files/foreign/pair_table.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

constexpr double kLevel = 1e-12;    // of a plane's normal
constexpr double kBridged = 10;     // clearances, a little more than the gap of a contact
constexpr double kPressed = 1e-6;   // metres, by which exports let weights press contacts together
constexpr double kSlabReach = 1.5;  // of the scene's size, to each side

Vec3 normal_of(const Pose& pose) { return pose.rotation.matrix().col(2); }

/// A plane of the world, in the world.
struct Plane {
  const ForeignCollider* collider;
  Pose pose;

  bool is_level() const {
    const Vec3 n = normal_of(pose);
    return std::abs(n.x()) <= kLevel && std::abs(n.y()) <= kLevel && n.z() > 0;
  }
};

std::vector<Plane> planes_of(const ForeignScene& scene) {
  std::vector<Plane> out;
  for (const ForeignBody& body : scene.bodies)
    for (const ForeignCollider& c : body.colliders)
      if (!c.mesh) out.push_back({&c, composed(body.pose, c.pose)});
  return out;
}

Aabb box_without_planes(const ForeignScene& scene) {
  Aabb box;
  for (const ForeignBody& body : scene.bodies)
    for (const ForeignCollider& c : body.colliders) {
      if (!c.mesh) continue;
      const Affine world = world_from_object(composed(body.pose, c.pose), UpAxis::Z, 1);
      for (const Vec3& v : c.mesh->vertices) box.extend(world.apply(v));
    }
  return box;
}

class Builder {
 public:
  explicit Builder(const ForeignScene& foreign)
      : m_foreign(foreign), m_planes(planes_of(foreign)), m_box(box_without_planes(foreign)) {}

  JudgedScene build() {
    choose_floor();
    const PairTable table = pair_table(m_foreign, m_floor, false);
    if (!m_foreign.joints.empty()) m_out.moving_links = pair_table(m_foreign, m_floor, true);
    m_out.scene.floor = m_floor != nullptr;
    m_out.scene.floor_kind = table.floor_kind;
    m_out.scene.pair_rules = table.rules;
    for (size_t i = 0; i < m_foreign.bodies.size(); ++i)
      m_out.ids.push_back(add(m_foreign.bodies[i], table.kinds[i]));
    m_out.clearance = clearance_of_margins();
    if (const auto why =
            refuse_too_coarse(m_out.scene, std::span<const PlacedBox>(), m_out.clearance))
      bad_file(m_foreign.files.at(0).path, message(*why));
    return std::move(m_out);
  }

 private:
  void choose_floor() {
    const auto level =
        std::find_if(m_planes.begin(), m_planes.end(), [](const Plane& p) { return p.is_level(); });
    if (level == m_planes.end()) return;
    m_floor = level->collider;
    m_out.lift = -level->pose.translation.z() + 0.0;
  }

  // Below its plane, wide enough for the whole scene.
  Mesh slab(const Pose& in_body, const Pose& body) const {
    const Pose world = composed(body, in_body);
    const Vec3 middle = m_box.empty() ? world.translation : m_box.centre();
    const double size = m_box.empty() ? 1.0 : m_box.diagonal();
    const Vec3 n = normal_of(world);
    const Vec3 foot = middle - n * n.dot(middle - world.translation);
    const double half = kSlabReach * size + (foot - middle).norm();
    Mesh box = box_mesh({half, half, half / 4});
    for (Vec3& v : box.vertices) v.z() = v.z() > 0 ? 0 : -half / 2;
    Mesh out;
    append(box, composed(inverse(body), {world.rotation, foot}), out);
    return out;
  }

  Mesh mesh_of(const ForeignBody& body) const {
    std::vector<Triangle> triangles;
    for (const ForeignCollider& c : body.colliders) {
      if (&c == m_floor) continue;
      Mesh part;
      if (c.mesh)
        append(*c.mesh, c.pose, part);
      else
        part = slab(c.pose, body.pose);
      for (Index f = 0; f < static_cast<Index>(part.triangles.size()); ++f)
        triangles.push_back(part.triangle(f));
    }
    return weld(triangles);
  }

  std::optional<ObjectId> add(const ForeignBody& body, PairKind kind) {
    Object object;
    object.name = body.name;
    object.fixed = body.fixed;
    object.pose = body.pose;
    object.pose.translation.z() += m_out.lift;
    object.pair_kind = kind;
    if (!body.colliders.empty()) object.material.friction = least_friction(body);
    Mesh mesh = mesh_of(body);
    // The world's body may be the floor alone.
    if (mesh.triangles.empty()) return std::nullopt;
    object.placed = true;
    const std::optional<GivenMass> mass = mass_of(body);
    const auto like = std::find_if(m_first.begin(), m_first.end(), [&](ObjectId id) {
      return is_like(m_out.scene.at(id), mesh, mass);
    });
    if (like == m_first.end()) {
      auto model = std::make_shared<Model>(model_of_mesh(std::move(mesh)));
      object.shape = make_shape(model->mesh);
      object.model = std::move(model);
      if (mass) give_mass(*mass, object);
    } else {
      const Object& first = m_out.scene.at(*like);
      object.model = first.model, object.shape = first.shape;
      object.given_mass = mass;
    }
    const ObjectId id = m_out.scene.add(std::move(object));
    if (like == m_first.end()) m_first.push_back(id);
    return id;
  }

  static bool is_like(const Object& first, const Mesh& mesh, const std::optional<GivenMass>& mass) {
    const Mesh& known = first.model->mesh;
    return known.vertices == mesh.vertices && known.triangles == mesh.triangles &&
           first.given_mass == mass;
  }

  std::optional<GivenMass> mass_of(const ForeignBody& body) {
    if (!body.mass || (body.fixed && !body.is_link)) return std::nullopt;
    const auto why = refuse_mass(*body.mass);
    if (!why) return body.mass;
    m_out.notes.push_back(say("the mass of \"%1\" is not used: %2", body.name, *why));
    return std::nullopt;
  }

  static double least_friction(const ForeignBody& body) {
    double least = kInfinity;
    for (const ForeignCollider& c : body.colliders) least = std::min(least, c.bits.friction);
    return std::clamp(least, kMinFriction, kMaxFriction);
  }

  // Two rest the sum of their margins apart: one clearance serves where all pairs ask for it.
  double clearance_of_margins() {
    double least = kInfinity, most = 0;
    for (const ForeignBody& body : m_foreign.bodies)
      for (const ForeignCollider& c : body.colliders) {
        least = std::min(least, c.bits.margin);
        most = std::max(most, c.bits.margin);
      }
    // Trivet's own exports bridge the gaps of contacts so: nothing is to be kept apart by it.
    if (2 * most <= kBridged * default_clearance(m_out.scene) + kPressed) return 0;
    if (least == most && 2 * most <= clearance_range(m_out.scene).largest) return 2 * most;
    if (least == most) {
      m_out.notes.push_back(
          say("margins of %1 mm are too large for a scene of this size, and are "
              "not kept: objects rest in contact",
              figure(1000 * most)));
      return 0;
    }
    m_out.notes.push_back(say("margins from %1 to %2 mm are not kept: objects rest in contact",
                              figure(1000 * least), figure(1000 * most)));
    return 0;
  }

  const ForeignScene& m_foreign;
  std::vector<Plane> m_planes;
  Aabb m_box;
  const ForeignCollider* m_floor = nullptr;
  std::vector<ObjectId> m_first;  // of each shape and mass: others that are alike share them
  JudgedScene m_out;
};

}  // namespace

JudgedScene judged_scene(const ForeignScene& foreign) { return Builder(foreign).build(); }

Pose pose_in_file(const JudgedScene& judged, Pose pose) {
  pose.translation.z() -= judged.lift;
  return pose;
}

}  // namespace trivet
