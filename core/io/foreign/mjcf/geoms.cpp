// Geoms: what collides, and what weighs.
#include <cmath>

#include "core/io/foreign/mjcf/model.h"
#include "core/io/foreign/primitives.h"

namespace trivet::mjcf {
namespace {

/// A geom's shape as it collides and as it weighs.
struct Solid {
  std::shared_ptr<const Mesh> mesh;
  SolidMoments moments;
};

/// Half sizes or radii, of which a fromto replaces the length; and the pose by it.
struct Extent {
  std::string type;
  Vec3 size = Vec3::Zero();
  Pose pose;
};

void use_fromto(const Attributes& a, Extent& out) {
  // The axis runs between two points, whose distance takes the place of a length.
  const std::vector<double> n = a.numbers("fromto", 6, 6);
  const Vec3 from(n[0], n[1], n[2]), to(n[3], n[4], n[5]);
  if (!((from - to).norm() > 1e-14))
    a.place().refuse("fromto", a.text("fromto"), "two points that differ");
  out.pose = {z_to(from - to), (from + to) / 2};
  const double half = (from - to).norm() / 2;
  const bool round = out.type == "capsule" || out.type == "cylinder";
  // Round shapes have radius and half length; others are as deep as they are wide.
  out.size = round ? Vec3(out.size.x(), half, 0) : Vec3(out.size.x(), out.size.x(), half);
}

Extent extent_of(const Attributes& a, const Settings& settings) {
  Extent out;
  out.type = a.text("type", "sphere");
  if (a.has("size")) {
    const std::vector<double> n = a.numbers("size", 1, 3);
    for (size_t i = 0; i < n.size(); ++i) out.size[static_cast<Index>(i)] = n[i];
  }
  out.pose = settings.pose(a);
  if (a.has("fromto")) use_fromto(a, out);
  return out;
}

void check_size(const Attributes& a, const Vec3& size, int least) {
  for (int i = 0; i < least; ++i)
    if (!(size[i] > 0)) a.place().refuse("size", a.text("size"), say("%1 positive numbers", least));
}

// Empty: it is no primitive of this kind. Without its mesh where that does not collide.
std::optional<Solid> primitive(const Attributes& a, const Extent& e, bool collides) {
  const auto made = [&](const auto& make_mesh, const SolidMoments& moments) {
    return Solid{collides ? std::make_shared<const Mesh>(make_mesh()) : nullptr, moments};
  };
  const Vec3& s = e.size;
  if (e.type == "box") {
    check_size(a, s, 3);
    return made([&] { return box_mesh(s); }, box_moments(s));
  }
  if (e.type == "sphere") {
    check_size(a, s, 1);
    const Vec3 radii = Vec3::Constant(s.x());
    return made([&] { return ball_mesh(s.x()); }, ellipsoid_moments(radii));
  }
  if (e.type == "ellipsoid") {
    check_size(a, s, 3);
    return made([&] { return ellipsoid_mesh(s); }, ellipsoid_moments(s));
  }
  if (e.type == "cylinder" || e.type == "capsule") {
    check_size(a, s, 2);
    return e.type == "cylinder"
               ? made([&] { return cylinder_mesh(s.x(), s.y()); }, cylinder_moments(s.x(), s.y()))
               : made([&] { return capsule_mesh(s.x(), s.y()); }, capsule_moments(s.x(), s.y()));
  }
  return std::nullopt;
}

Solid of_mesh(const Attributes& a, const std::string& type, bool collides,
              const ForeignOptions& options, Assets& assets, Sentence& trouble) {
  const MeshAsset* const asset = assets.find(a.text("mesh"));
  trouble = asset ? asset->trouble : say("no mesh is named \"%1\"", a.text("mesh"));
  if (!asset || !trouble.empty()) return {};
  Solid out;
  // The mass is that of the mesh, also where its hull collides.
  const bool shell = a.text("shellinertia") == "true";
  out.moments = mesh_moments(*asset->mesh, shell ? MeshMass::Shell : asset->rule);
  if (!collides) return out;
  // MuJoCo collides hulls of meshes.
  out.mesh = type == "sdf" || options.true_meshes ? asset->mesh : asset->hull();
  if (out.mesh->triangles.empty()) trouble = Sentence("a flat mesh has no hull");
  return out;
}

// An int of MuJoCo; -1 has all bits.
std::int64_t whole_number(const Attributes& a, const char* name, double otherwise) {
  const double value = a.number(name, otherwise);
  if (!(value >= -2147483648.0 && value <= 2147483647.0) || value != std::floor(value))
    a.place().refuse(name, a.text(name), "whole numbers of 32 bits");
  return static_cast<std::int64_t>(value);
}

ContactBits bits_of(const Attributes& a) {
  ContactBits bits;
  bits.type = static_cast<std::uint32_t>(whole_number(a, "contype", 1));
  bits.affinity = static_cast<std::uint32_t>(whole_number(a, "conaffinity", 1));
  bits.friction = a.has("friction") ? a.numbers("friction", 1, 3)[0] : 1;
  bits.priority = static_cast<int>(whole_number(a, "priority", 0));
  bits.margin = a.number("margin", 0);
  return bits;
}

bool weighs(const Attributes& a, const Settings& settings) {
  // Geoms of groups outside the range weigh nothing.
  const std::string range = settings.compiler("inertiagrouprange", "0 5");
  const std::vector<double> n = numbers_in(range, "inertiagrouprange", a.place(), 2, 2);
  const double group = a.number("group", 0);
  return n[0] <= group && group <= n[1];
}

void add_mass(const Attributes& a, const Solid& solid, const Pose& pose, const Settings& settings,
              Body& body) {
  if (!weighs(a, settings)) return;
  // A mass that is given wins over density and volume.
  const double kilograms =
      a.has("mass") ? a.number("mass", 0) : a.number("density", 1000) * solid.moments.volume;
  if (kilograms > 0) body.of_geoms.add(kilograms, solid.moments, pose);
}

std::string name_of(const Body& body, const Attributes& a) {
  const std::string name = a.text("name");
  return name.empty() ? "geom " + std::to_string(body.geoms.size() + 1) : name;
}

}  // namespace

void read_geom(const Attributes& a, const Pose& frame, const Settings& settings, Assets& assets,
               const ForeignOptions& options, Body& body, ForeignScene& scene) {
  const Extent extent = extent_of(a, settings);
  Geom geom;
  geom.collider.name = name_of(body, a);
  geom.collider.pose = composed(frame, extent.pose);
  geom.collider.bits = bits_of(a);
  geom.collides = geom.collider.bits.type != 0 || geom.collider.bits.affinity != 0;
  const auto skip = [&](const Sentence& why) {
    Sentence what = say("%1: %2", a.place().text(), why);
    geom.collides ? note_once(scene.unread, std::move(what))
                  : note_once(scene.notes, std::move(what));
  };
  // A plane has no inside and no mass.
  if (extent.type == "plane") {
    geom.is_plane = true;
    if (geom.collides) body.geoms.push_back(std::move(geom));
    return;
  }
  // A geom that neither collides nor weighs is not built.
  if (!geom.collides && !body.needs_mass) return;
  const bool is_mesh = extent.type == "mesh" || extent.type == "sdf";
  if (a.has("mesh") && !is_mesh) return skip("a geom fitted to a mesh is not read");
  Solid solid;
  Sentence trouble;
  if (is_mesh) {
    solid = of_mesh(a, extent.type, geom.collides, options, assets, trouble);
  } else if (auto found = primitive(a, extent, geom.collides)) {
    solid = std::move(*found);
  } else {
    trouble = say("a geom of the type \"%1\" is not read", extent.type);
  }
  if (!trouble.empty()) return skip(trouble);
  // Mass first: a geom may weigh without colliding.
  add_mass(a, solid, geom.collider.pose, settings, body);
  if (!geom.collides) return;
  count_faces(*solid.mesh, scene);
  geom.collider.mesh = std::move(solid.mesh);
  if (extent.type == "sphere") geom.collider.ball_radius = extent.size.x();
  body.geoms.push_back(std::move(geom));
}

std::optional<GivenMass> mass_of(const Body& body, const Settings& settings) {
  const std::string rule = settings.compiler("inertiafromgeom", "auto");
  // By the rule of the compiler, geoms or the inertial decide; auto prefers what is given.
  const bool by_geoms = rule == "true" || (rule == "auto" && !body.inertial);
  std::optional<GivenMass> out = by_geoms ? body.of_geoms.total() : body.inertial;
  const double least = settings.compiler_number("boundmass", 0);
  if (out && out->kilograms < least) out->kilograms = least;
  return out;
}

}  // namespace trivet::mjcf
