#include "core/io/foreign/usd/usda_bodies.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/io/foreign/usd/usda_shapes.h"

namespace trivet {
namespace {

constexpr double kUsdaFriction = 0.5;  // of colliders without a physical material, as PhysX has it

/// The place that the walk has reached.
struct AtPrim {
  UsdaFrame world, in_body;
  std::optional<size_t> body;
  std::string physics_material, material;  // nearest bindings
  int depth = 0;
};

/// Mass of a body as its prim and those of its colliders give it.
struct BodyMass {
  std::optional<double> kilograms, density;
  std::optional<Vec3> centre;
  std::optional<Mat3> inertia;
  MassSum sum;
  bool parts_say = false;  // a collider or a material has a mass or a density
};

bool contains_body(const UsdaPrim& prim) {
  return prim.has_api("PhysicsRigidBodyAPI") ||
         std::any_of(prim.children.begin(), prim.children.end(), contains_body);
}

bool contains_physics(const UsdaPrim& prim) {
  return prim.has_api("PhysicsRigidBodyAPI") || prim.has_api("PhysicsCollisionAPI") ||
         std::any_of(prim.children.begin(), prim.children.end(), contains_physics);
}

void index_prims(const std::vector<UsdaPrim>& prims,
                 std::map<std::string_view, const UsdaPrim*>& out) {
  for (const UsdaPrim& prim : prims) {
    out.emplace(prim.path, &prim);
    index_prims(prim.children, out);
  }
}

std::optional<double> positive(std::optional<double> value) {
  return value && *value > 0 ? value : std::nullopt;
}

class BodyWalk {
 public:
  BodyWalk(const ForeignOptions& options, UsdaBodies& out, ForeignScene& scene)
      : m_options(options), m_out(out), m_scene(scene) {}

  void walk_all() {
    AtPrim top;
    top.world = m_out.units.root;
    for (const UsdaPrim& prim : m_out.stage.prims) walk(prim, top);
    for (size_t i = 0; i < m_scene.bodies.size(); ++i) give_mass_of(i);
    choose_friction_rule();
  }

 private:
  void walk(const UsdaPrim& prim, AtPrim at) {
    const UsdaOps ops = usda_ops(prim, m_scene.unread);
    const UsdaFrame parent = ops.resets ? m_out.units.root : at.world;
    const UsdaFrame local = ops.local();
    at.world = composed(parent, local);
    at.in_body = composed(at.in_body, local);
    if (ops.resets) at.body.reset();
    bind_materials(prim, at);
    if (prim.type == "PointInstancer") return name_copies(prim);
    if (prim.has_api("PhysicsRigidBodyAPI") && usda_flag(prim, "physics:rigidBodyEnabled", true))
      begin_body(prim, {prim.path, parent, ops, {}}, false, at);
    else if (!at.body && is_fixed_object(prim, at))
      begin_body(prim, {}, true, at);
    note_prim(prim);
    if (prim.has_api("PhysicsCollisionAPI") && usda_flag(prim, "physics:collisionEnabled", true))
      add_collider(prim, at);
    ++at.depth;
    for (const UsdaPrim& child : prim.children) walk(child, at);
  }

  void name_copies(const UsdaPrim& prim) {
    if (contains_physics(prim))
      note_once(m_scene.unread, say("%1: copies of a PointInstancer are not read", prim.path));
  }

  void bind_materials(const UsdaPrim& prim, AtPrim& at) const {
    const auto bind = [&](const char* relationship, std::string& to) {
      const std::vector<std::string> targets = prim.targets(relationship);
      if (!targets.empty()) to = targets[0];
    };
    bind("material:binding:physics", at.physics_material);
    bind("material:binding", at.material);
  }

  // An asset without bodies is one object.
  static bool is_fixed_object(const UsdaPrim& prim, const AtPrim& at) {
    if (at.depth == 0) return false;
    const bool is_named = prim.is_asset || prim.find("trivet:name") ||
                          usda_word(prim.metadata("kind")) == "component";
    return is_named && !contains_body(prim);
  }

  void begin_body(const UsdaPrim& prim, UsdaPlace place, bool fixed, AtPrim& at) {
    at.body = m_scene.bodies.size();
    at.in_body = {{}, at.world.linear};
    ForeignBody body;
    body.name = m_names(usda_name(prim));
    body.pose = {at.world.pose.rotation.normalized(), at.world.pose.translation};
    body.fixed = fixed || usda_flag(prim, "physics:kinematicEnabled", false);
    body.weld = static_cast<int>(*at.body) + 1;
    body.place.kind = PosePlace::Kind::Prim, body.place.number = *at.body;
    if (prim.in_instance || fixed) {
      body.place.kind = PosePlace::Kind::Nowhere;
      body.place.why_not = fixed ? Sentence("it is fixed") : Sentence("it is inside an instance");
    }
    m_scene.bodies.push_back(std::move(body));
    m_out.places.push_back({std::move(place)});
    m_out.body_of_path[prim.path] = *at.body;
    m_masses.push_back(mass_of_prim(prim, at.world.linear));
  }

  BodyMass mass_of_prim(const UsdaPrim& prim, const Mat3& linear) const {
    BodyMass out;
    const UsdaUnits& units = m_out.units;
    if (const auto mass = positive(usda_number(prim, "physics:mass")))
      out.kilograms = *mass * units.kilograms;
    out.density = density_of(prim);
    if (const auto centre = usda_vector(prim, "physics:centerOfMass"))
      out.centre = linear * *centre;
    const auto inertia = usda_vector(prim, "physics:diagonalInertia");
    if (!inertia || inertia->isZero(0)) return out;
    const Mat3 axes = usda_turn(prim, "physics:principalAxes").value_or(Rotation{}).matrix();
    const Mat3 diagonal = inertia->asDiagonal();
    out.inertia =
        units.kilograms * units.metres * units.metres * (axes * diagonal * axes.transpose());
    return out;
  }

  // Kilograms per cubic metre.
  std::optional<double> density_of(const UsdaPrim& prim) const {
    const auto density = positive(usda_number(prim, "physics:density"));
    if (!density) return std::nullopt;
    const double m = m_out.units.metres;
    return *density * m_out.units.kilograms / (m * m * m);
  }

  void note_prim(const UsdaPrim& prim) {
    if (prim.type.starts_with("Physics") && prim.type.ends_with("Joint"))
      m_out.joints.push_back(&prim);
    if (prim.type == "PhysicsCollisionGroup") m_out.groups.push_back(&prim);
    if (prim.has_api("PhysicsFilteredPairsAPI")) m_out.filters.push_back(&prim);
    const auto gravity = usda_vector(prim, "physics:gravityDirection");
    if (prim.type == "PhysicsScene" && gravity && !gravity->isZero(0) &&
        (gravity->normalized() + m_out.units.up).norm() > 1e-6)
      note_once(m_scene.unread, say("%1: gravity is taken to go down", prim.path));
  }

  void add_collider(const UsdaPrim& prim, AtPrim at) {
    if (!is_usda_shape(prim.type)) {
      note_once(m_scene.unread, say("%1: a collider of type \"%2\" is not read", prim.path,
                                    prim.type.empty() ? std::string("none") : prim.type));
      return;
    }
    if (!at.body) begin_body(prim, {}, true, at);
    auto collider = usda_collider(prim, at.in_body, m_options.true_meshes, m_scene.unread);
    if (!collider) return;
    const UsdaPrim* const material = material_of(at);
    collider->bits.friction = friction_of(material);
    if (const auto offset = positive(usda_number(prim, "physxCollision:restOffset")))
      collider->bits.margin = *offset * m_out.units.metres;
    if (collider->mesh) {
      count_faces(*collider->mesh, m_scene);
      add_part_mass(prim, material, *collider, m_masses[*at.body]);
    }
    m_scene.bodies[*at.body].colliders.push_back(std::move(*collider));
  }

  const UsdaPrim* material_of(const AtPrim& at) const {
    for (const std::string& path : {at.physics_material, at.material}) {
      const UsdaPrim* const prim = path.empty() ? nullptr : m_out.prim_at(path);
      if (prim && prim->has_api("PhysicsMaterialAPI")) return prim;
    }
    return nullptr;
  }

  double friction_of(const UsdaPrim* material) {
    if (!material) return kUsdaFriction;
    const std::string mode = usda_word(material->find("physxMaterial:frictionCombineMode"));
    m_modes.insert(mode.empty() ? "average" : mode);
    return std::max(0.0, usda_number(*material, "physics:staticFriction").value_or(0));
  }

  void add_part_mass(const UsdaPrim& prim, const UsdaPrim* material,
                     const ForeignCollider& collider, BodyMass& mass) const {
    const SolidMoments moments = mesh_moments(*collider.mesh, MeshMass::Exact);
    auto kilograms = positive(usda_number(prim, "physics:mass"));
    auto density = density_of(prim);
    if (!density && material) density = density_of(*material);
    mass.parts_say |= kilograms || density;
    if (!density) density = mass.density ? mass.density : 1000.0;
    const double volume = std::abs(moments.volume);
    mass.sum.add(kilograms ? *kilograms * m_out.units.kilograms : *density * volume, moments,
                 collider.pose);
  }

  void give_mass_of(size_t i) {
    const BodyMass& mass = m_masses[i];
    ForeignBody& body = m_scene.bodies[i];
    if (body.fixed) return;
    if (mass.kilograms)
      body.mass = GivenMass{*mass.kilograms, mass.centre, mass.inertia};
    else if (mass.parts_say || mass.density)
      body.mass = mass.sum.total();
  }

  void choose_friction_rule() {
    static const std::map<std::string, FrictionRule> rules = {{"average", FrictionRule::Mean},
                                                              {"max", FrictionRule::Larger},
                                                              {"min", FrictionRule::Smaller},
                                                              {"multiply", FrictionRule::Product}};
    m_scene.friction_rule = FrictionRule::Mean;
    if (m_modes.size() > 1)
      note_once(m_scene.notes, Sentence("materials differ in how friction of two is combined: "
                                        "their mean is taken"));
    if (m_modes.size() == 1 && rules.count(*m_modes.begin()))
      m_scene.friction_rule = rules.at(*m_modes.begin());
  }

  const ForeignOptions& m_options;
  UsdaBodies& m_out;
  ForeignScene& m_scene;
  UniqueNames m_names;
  std::vector<BodyMass> m_masses;  // by body
  std::set<std::string> m_modes;   // of combining friction
};

}  // namespace

std::string usda_name(const UsdaPrim& prim) {
  if (const std::string own = usda_word(prim.find("trivet:name")); !own.empty()) return own;
  const std::string displayed = usda_word(prim.metadata("displayName"));
  return displayed.empty() ? prim.name : displayed;
}

const UsdaPrim* UsdaBodies::prim_at(const std::string& path) const {
  const auto it = prim_of_path.find(path);
  return it == prim_of_path.end() ? nullptr : it->second;
}

UsdaFrame UsdaBodies::frame_at(const std::string& path) const {
  UsdaFrame out = units.root;
  std::vector<Sentence> told_already;
  for (size_t end = 0; end < path.size();) {
    end = std::min(path.find('/', end + 1), path.size());
    const UsdaPrim* const prim = prim_at(path.substr(0, end));
    if (!prim) break;
    const UsdaOps ops = usda_ops(*prim, told_already);
    out = composed(ops.resets ? units.root : out, ops.local());
  }
  return out;
}

std::vector<size_t> UsdaBodies::bodies_at(const std::string& path) const {
  if (!path.starts_with('/')) return {};
  for (std::string at = path; !at.empty(); at.erase(at.rfind('/')))
    if (const auto it = body_of_path.find(at); it != body_of_path.end()) return {it->second};
  std::vector<size_t> out;
  const std::string below = path + "/";
  for (auto it = body_of_path.lower_bound(below);
       it != body_of_path.end() && it->first.starts_with(below); ++it)
    out.push_back(it->second);
  return out;
}

void collect_usda_bodies(const ForeignOptions& options, UsdaBodies& out, ForeignScene& scene) {
  index_prims(out.stage.prims, out.prim_of_path);
  BodyWalk(options, out, scene).walk_all();
}

}  // namespace trivet
