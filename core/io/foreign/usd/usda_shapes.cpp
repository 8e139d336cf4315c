#include "core/io/foreign/usd/usda_shapes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/exact/triangulate.h"
#include "core/io/foreign/primitives.h"
#include "core/io/surface/coordinate_limit.h"

namespace trivet {
namespace {

// Faces of many corners cost up to the third power of these to cut: scenes are not trusted.
constexpr size_t kMostCorners = 1024;
constexpr size_t kMostSquares = 100'000'000;  // sum of squared corners of a mesh

using ShapeMaker = std::optional<Mesh> (*)(const UsdaPrim& prim, Sentence& why);

double size_of(const UsdaPrim& prim, const char* property, double otherwise) {
  return usda_number(prim, property).value_or(otherwise);
}

double radius_of_sphere(const UsdaPrim& prim) { return size_of(prim, "radius", 1); }

/// Turns z to the axis of the prim.
Rotation turn_to_axis(const UsdaPrim& prim) {
  const std::string axis = usda_word(prim.find("axis"));
  if (axis == "X") return turn_about(Vec3::UnitY(), 90).normalized();
  if (axis == "Y") return turn_about(Vec3::UnitX(), -90).normalized();
  return {};
}

Mesh turned_to_axis(const UsdaPrim& prim, const Mesh& mesh) {
  Mesh out;
  append(mesh, {turn_to_axis(prim), Vec3::Zero()}, out);
  return out;
}

std::optional<Mesh> cube_of(const UsdaPrim& prim, Sentence&) {
  return box_mesh(Vec3::Constant(size_of(prim, "size", 2) / 2));
}
std::optional<Mesh> sphere_of(const UsdaPrim& prim, Sentence&) {
  return ball_mesh(radius_of_sphere(prim));
}
std::optional<Mesh> cylinder_of(const UsdaPrim& prim, Sentence&) {
  return turned_to_axis(prim,
                        cylinder_mesh(size_of(prim, "radius", 1), size_of(prim, "height", 2) / 2));
}
std::optional<Mesh> capsule_of(const UsdaPrim& prim, Sentence&) {
  return turned_to_axis(prim,
                        capsule_mesh(size_of(prim, "radius", 0.5), size_of(prim, "height", 1) / 2));
}
std::optional<Mesh> cone_of(const UsdaPrim& prim, Sentence&) {
  // The foot is the lower half of a cylinder's; its upper ring becomes the tip.
  Mesh mesh = cylinder_mesh(size_of(prim, "radius", 1), size_of(prim, "height", 2) / 2);
  for (Vec3& v : mesh.vertices)
    if (v.z() > 0) v.x() = v.y() = 0;
  return turned_to_axis(prim, hull_mesh(mesh.vertices));
}

/// Faces of any number of corners, as triangles.
class MeshOfPrim {
 public:
  explicit MeshOfPrim(const UsdaPrim& prim)
      : m_counts(prim.find("faceVertexCounts")), m_corners(prim.find("faceVertexIndices")) {
    if (const UsdaEntry* const points = prim.find("points"))
      for (size_t i = 0; i + 2 < points->value.numbers.size(); i += 3)
        m_mesh.vertices.emplace_back(points->value.numbers[i], points->value.numbers[i + 1],
                                     points->value.numbers[i + 2]);
    m_left_handed = usda_word(prim.find("orientation")) == "leftHanded";
  }

  std::optional<Mesh> read(Sentence& why) {
    const bool in_range = std::all_of(
        m_mesh.vertices.begin(), m_mesh.vertices.end(),
        [](const Vec3& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate; });
    if (!in_range || m_mesh.vertices.empty() || !m_counts || !m_corners || !add_faces()) {
      why = Sentence("its points and faces do not fit together, or are too many");
      return std::nullopt;
    }
    return std::move(m_mesh);
  }

 private:
  // False: a count or an index is out of range, or faces have too many corners.
  bool add_faces() {
    const std::vector<double>& corners = m_corners->value.numbers;
    size_t at = 0;
    for (const double count : m_counts->value.numbers) {
      if (!(count >= 0) || !(count <= static_cast<double>(corners.size() - at))) return false;
      const auto n = static_cast<size_t>(count);
      m_squares += n > 4 ? n * n : 0;
      if (n > kMostCorners || m_squares > kMostSquares) return false;
      if (!add_face(std::span(corners).subspan(at, n))) return false;
      at += n;
    }
    return true;
  }

  bool add_face(std::span<const double> corners) {
    std::vector<Vec3> points;
    for (const double corner : corners) {
      if (!(corner >= 0) || !(corner < static_cast<double>(m_mesh.vertices.size()))) return false;
      points.push_back(m_mesh.vertices[static_cast<size_t>(corner)]);
    }
    std::vector<Index3> triangles;
    if (corners.size() == 3) triangles.push_back({0, 1, 2});
    if (corners.size() > 3) triangulate(points, triangles);
    for (const Index3& t : triangles) {
      Index3 face;
      for (size_t k = 0; k < 3; ++k)
        face[k] = static_cast<Index>(corners[static_cast<size_t>(t[k])]);
      if (m_left_handed) std::swap(face[1], face[2]);
      m_mesh.triangles.push_back(face);
    }
    return true;
  }

  const UsdaEntry *m_counts, *m_corners;
  Mesh m_mesh;
  bool m_left_handed = false;
  size_t m_squares = 0;
};

std::optional<Mesh> mesh_of_prim(const UsdaPrim& prim, Sentence& why) {
  return MeshOfPrim(prim).read(why);
}

const std::map<std::string, ShapeMaker>& shape_makers() {
  static const std::map<std::string, ShapeMaker> makers = {
      {"Capsule", capsule_of},   {"Cone", cone_of},      {"Cube", cube_of},
      {"Cylinder", cylinder_of}, {"Mesh", mesh_of_prim}, {"Sphere", sphere_of}};
  return makers;
}

// The mesh as the file's engines collide it.
Mesh approximated(const UsdaPrim& prim, Mesh mesh, bool true_meshes,
                  std::vector<Sentence>& unread) {
  const std::string rule = usda_word(prim.find("physics:approximation"));
  if (prim.type != "Mesh" || true_meshes || !prim.has_api("PhysicsMeshCollisionAPI")) return mesh;
  if (rule == "convexHull") return hull_mesh(mesh.vertices);
  // Engines differ in what they make of these; the mesh itself is what they come near to.
  if (rule == "boundingCube" || rule == "boundingSphere")
    note_once(unread, say("%1: the approximation \"%2\" is not read: its mesh is taken as it is",
                          prim.path, rule));
  return mesh;
}

}  // namespace

std::optional<double> usda_number(const UsdaPrim& prim, std::string_view property) {
  const UsdaEntry* const entry = prim.find(property);
  if (!entry || entry->value.numbers.size() != 1 || !std::isfinite(entry->value.numbers[0]))
    return std::nullopt;
  return entry->value.numbers[0];
}

std::optional<Vec3> usda_vector(const UsdaPrim& prim, std::string_view property) {
  const UsdaEntry* const entry = prim.find(property);
  if (!entry || entry->value.numbers.size() != 3) return std::nullopt;
  const Vec3 out(entry->value.numbers.data());
  return out.allFinite() ? std::optional(out) : std::nullopt;
}

std::optional<Rotation> usda_turn(const UsdaPrim& prim, std::string_view property) {
  const UsdaEntry* const entry = prim.find(property);
  if (!entry || entry->value.numbers.size() != 4) return std::nullopt;
  const std::vector<double>& n = entry->value.numbers;
  const bool finite = std::all_of(n.begin(), n.end(), [](double v) { return std::isfinite(v); });
  return finite ? std::optional(Rotation{n[0], n[1], n[2], n[3]}.normalized()) : std::nullopt;
}

std::string usda_word(const UsdaEntry* entry) {
  return entry && !entry->value.words.empty() ? entry->value.words[0].second : "";
}

bool usda_flag(const UsdaPrim& prim, std::string_view property, bool otherwise) {
  const UsdaEntry* const entry = prim.find(property);
  if (!entry) return otherwise;
  if (!entry->value.numbers.empty()) return entry->value.numbers[0] != 0;
  const std::string word = usda_word(entry);
  return word == "true" || (word != "false" && otherwise);
}

bool is_usda_shape(const std::string& type) {
  return type == "Plane" || shape_makers().count(type) != 0;
}

std::optional<ForeignCollider> usda_collider(const UsdaPrim& prim, const UsdaFrame& in_body,
                                             bool true_meshes, std::vector<Sentence>& unread) {
  ForeignCollider out;
  out.name = prim.name;
  out.pose = in_body.pose;
  if (prim.type == "Plane") {
    out.pose.rotation = (out.pose.rotation * turn_to_axis(prim)).normalized();
    return out;
  }
  Sentence why("is not read");
  const auto maker = shape_makers().find(prim.type);
  std::optional<Mesh> mesh =
      maker == shape_makers().end() ? std::nullopt : maker->second(prim, why);
  if (mesh) mesh = approximated(prim, std::move(*mesh), true_meshes, unread);
  if (!mesh || mesh->triangles.empty()) {
    note_once(unread, say("%1: %2", prim.path, why));
    return std::nullopt;
  }
  const std::optional<double> scale = uniform_scale(in_body.linear);
  if (prim.type == "Sphere" && scale) out.ball_radius = *scale * radius_of_sphere(prim);
  for (Vec3& v : mesh->vertices) v = in_body.linear * v;
  if (in_body.linear.determinant() < 0)
    for (Index3& t : mesh->triangles) std::swap(t[1], t[2]);
  out.mesh = std::make_shared<const Mesh>(std::move(*mesh));
  return out;
}

}  // namespace trivet
