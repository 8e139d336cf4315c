#include "core/io/mesh/assembly.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/io/mesh/node_product.h"
#include "core/io/mesh/normals.h"
#include "core/mesh/weld_arrays.h"

namespace trivet {
namespace {

constexpr double kMaxCoordinate = 1e30;  // squares and cubes of it stay finite in double

std::string coordinates(const Eigen::Vector3f& v) {
  std::ostringstream out;
  out.precision(9);
  out << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  return out.str();
}

bool is_within(const Vec3& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate; }

}  // namespace

void ModelAssembly::expect(std::uint64_t num_triangles) {
  if (num_triangles > static_cast<std::uint64_t>(m_limits.max_triangles))
    bad_input("%1 faces, more than the limit of %2", num_triangles, m_limits.max_triangles);
  m_triangles.reserve(num_triangles);
  m_model.face_material.reserve(num_triangles);
  m_model.corner_normals.reserve(num_triangles);
}

void ModelAssembly::place(const MeshVertices& mesh, const Affine& object_from_mesh) {
  m_mesh = mesh;
  m_object_from_mesh = object_from_mesh;
  const Mat3& linear = object_from_mesh.linear;
  // Cofactors are the inverse transpose times the determinant: only its sign remains to be applied.
  m_mirrored = mirrors(object_from_mesh);
  for (int r = 0; r < 3; ++r)
    m_normal_matrix.row(r) =
        (m_mirrored ? -1.0 : 1.0) * linear.row((r + 1) % 3).cross(linear.row((r + 2) % 3));
  ++m_placement;
  if (m_placed.size() < mesh.positions.size()) m_placed.resize(mesh.positions.size());
}

void ModelAssembly::check(std::uint32_t vertex, const Vec3& point) const {
  if (is_within(point)) return;
  const Eigen::Vector3f& own = m_mesh.positions[vertex];
  const bool own_fault = !is_within(own.cast<double>());
  bad_input("mesh '%1': %2", m_mesh.name,
            say(point.allFinite() ? TRIVET_SENTENCE("vertex %1 %2 lies beyond 1e30%3")
                                  : TRIVET_SENTENCE("vertex %1 %2 is not finite%3"),
                vertex, coordinates(own),
                own_fault ? Sentence() : Sentence(" after the transform of its node")));
}

// The zero vector stands for a missing normal until fill_missing_normals().
Eigen::Vector3f ModelAssembly::placed_normal(std::uint32_t vertex) const {
  if (m_mesh.normals.empty()) return Eigen::Vector3f::Zero();
  const Vec3 turned = m_normal_matrix * m_mesh.normals[vertex].cast<double>();
  const double length = turned.norm();
  if (!std::isfinite(length) || length == 0) return Eigen::Vector3f::Zero();
  return (turned / length).cast<float>();
}

const ModelAssembly::Placed& ModelAssembly::placed(std::uint32_t vertex) {
  Placed& out = m_placed[vertex];
  if (out.placement == m_placement) return out;
  const Vec3 point = m_object_from_mesh.apply(m_mesh.positions[vertex].cast<double>());
  check(vertex, point);
  out = {m_placement, static_cast<Index>(m_vertices.size()), placed_normal(vertex)};
  m_vertices.push_back(point);
  m_has_normals |= !out.normal.isZero(0);
  return out;
}

void ModelAssembly::add(const Corners& corners, Index material) {
  Index3 triangle;
  auto& normals = m_model.corner_normals.emplace_back();
  for (size_t k = 0; k < 3; ++k) {
    const Placed& corner = placed(corners[m_mirrored && k > 0 ? 3 - k : k]);
    triangle[k] = corner.id;
    normals[k] = corner.normal;
  }
  m_triangles.push_back(triangle);
  m_model.face_material.push_back(material);
}

void ModelAssembly::finish(bool keeps_normals) {
  if (m_triangles.empty())
    bad_input(m_model.notes.empty() ? "contains no triangle"
                                    : say("contains no triangle (%1)", m_model.notes.front()));
  m_model.mesh = weld(m_vertices, m_triangles).mesh;
  if (m_has_normals && keeps_normals)
    fill_missing_normals(m_model.mesh, m_model.corner_normals);
  else
    m_model.corner_normals = {};
}

}  // namespace trivet
