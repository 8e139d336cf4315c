#include "apps/demo/shapes/assemble.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trivet::shapes {
namespace {

// A face's share of a vertex's normal; exact for vertices on a sphere.
Vec3 weighted_normal(const Mesh& mesh, Index face, int corner) {
  const Triangle t = mesh.triangle(face);
  const Vec3 u = t[(corner + 1) % 3] - t[corner], v = t[(corner + 2) % 3] - t[corner];
  return u.cross(v) / (u.squaredNorm() * v.squaredNorm());
}

Vec3 face_normal(const Mesh& mesh, Index face) {
  const Triangle t = mesh.triangle(face);
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  return n / n.norm();
}

using CornerNormals = std::vector<std::array<Eigen::Vector3f, 3>>;

void append_normals(const Mesh& mesh, double hard_cos, CornerNormals* out) {
  std::vector<std::vector<std::pair<Index, int>>> corners(mesh.vertices.size());
  const auto num_faces = static_cast<Index>(mesh.triangles.size());
  std::vector<Vec3> normals;
  for (Index f = 0; f < num_faces; ++f) {
    normals.push_back(face_normal(mesh, f));
    for (int c = 0; c < 3; ++c) corners[mesh.triangles[f][c]].emplace_back(f, c);
  }
  for (Index f = 0; f < num_faces; ++f) {
    std::array<Eigen::Vector3f, 3> at_corners;
    for (int c = 0; c < 3; ++c) {
      Vec3 sum = Vec3::Zero();
      for (const auto& [g, k] : corners[mesh.triangles[f][c]])
        if (normals[f].dot(normals[g]) >= hard_cos) sum += weighted_normal(mesh, g, k);
      at_corners[c] = (sum / sum.norm()).cast<float>();
    }
    out->push_back(at_corners);
  }
}

double lowest(const std::vector<Part>& parts) {
  double z = kInfinity;
  for (const Part& part : parts)
    for (const Triangle& t : part.surface.triangles)
      for (const Vec3& p : t) z = std::min(z, p.z());
  return z;
}

}  // namespace

double snap_to_grid(double x) { return std::nearbyint(x / kGrid) * kGrid + 0.0; }

Vec3 snap_to_grid(const Vec3& p) {
  return {snap_to_grid(p.x()), snap_to_grid(p.y()), snap_to_grid(p.z())};
}

Material make_material(std::string name, float red, float green, float blue, float roughness,
                       float metallic) {
  return {std::move(name), {red, green, blue, 1.0f}, metallic, roughness};
}

Model assemble(const std::string& name, const std::vector<Part>& parts,
               std::vector<Material> materials, bool on_floor) {
  const Vec3 shift(0, 0, on_floor ? -lowest(parts) : 0);
  Model model;
  model.path = name;
  model.format = "made";
  model.materials = std::move(materials);
  model.num_nodes = 1;
  std::vector<Triangle> all;
  for (const Part& part : parts) {
    std::vector<Triangle> triangles = part.surface.triangles;
    for (Triangle& t : triangles)
      for (Vec3& p : t) p = snap_to_grid(Vec3(p + shift));
    const double hard_cos = std::cos(part.hard_angle_deg * std::numbers::pi / 180);
    append_normals(weld(triangles), hard_cos, &model.corner_normals);
    all.insert(all.end(), triangles.begin(), triangles.end());
    const auto& m = part.surface.materials;
    model.face_material.insert(model.face_material.end(), m.begin(), m.end());
  }
  model.mesh = weld(all);
  return model;
}

}  // namespace trivet::shapes
