#include "core/io/mesh/normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr double kCosCrease = 0.766044443;  // 40 degrees
constexpr Index kMaxValence = 256;          // above, comparing all pairs costs too much

struct Faces {
  std::vector<Vec3> weighted;  // length: twice the area
  std::vector<Vec3> unit;      // zero without area
};

Faces face_normals(const Mesh& mesh) {
  Faces out;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    // Scaled by the longest side, so that squares neither overflow nor underflow.
    const Vec3 u = t[1] - t[0], v = t[2] - t[0];
    const double scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
    const Vec3 normal = scale > 0 ? Vec3((u / scale).cross(v / scale)) : Vec3(Vec3::Zero());
    const double length = normal.norm();
    out.unit.push_back(length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero()));
    out.weighted.push_back(scale * scale * normal);
  }
  return out;
}

/// Corners (3 x face + corner) at each vertex, rows in one array.
struct Corners {
  std::vector<Index> offsets, items;
};

Corners corners_of_vertices(const Mesh& mesh) {
  Corners out;
  out.offsets.assign(mesh.vertices.size() + 1, 0);
  for (const Index3& t : mesh.triangles)
    for (Index v : t) ++out.offsets[v + 1];
  for (size_t v = 0; v < mesh.vertices.size(); ++v) out.offsets[v + 1] += out.offsets[v];
  out.items.resize(3 * mesh.triangles.size());
  std::vector<Index> next(out.offsets.begin(), out.offsets.end() - 1);
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k)
      out.items[next[mesh.triangles[f][k]]++] = static_cast<Index>(3 * f + k);
  return out;
}

Eigen::Vector3f unit_or(const Vec3& sum, const Vec3& fallback) {
  const double scale = sum.cwiseAbs().maxCoeff();
  if (scale > 0 && std::isfinite(scale)) return (sum / scale).normalized().cast<float>();
  return fallback.isZero() ? Eigen::Vector3f(Eigen::Vector3f::UnitZ())
                           : Eigen::Vector3f(fallback.cast<float>());
}

}  // namespace

CornerNormals smooth_normals(const Mesh& mesh) {
  const Faces faces = face_normals(mesh);
  const Corners corners = corners_of_vertices(mesh);
  CornerNormals out(mesh.triangles.size());
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Index begin = corners.offsets[v], end = corners.offsets[v + 1];
    for (Index i = begin; i < end; ++i) {
      const Index face = corners.items[i] / 3;
      const Vec3& own = faces.unit[face];
      Vec3 sum = Vec3::Zero();
      for (Index j = begin; end - begin <= kMaxValence && j < end; ++j) {
        const Index other = corners.items[j] / 3;
        if (own.isZero() || own.dot(faces.unit[other]) >= kCosCrease) sum += faces.weighted[other];
      }
      out[face][corners.items[i] % 3] = unit_or(sum, own);
    }
  }
  return out;
}

void fill_missing_normals(const Mesh& mesh, CornerNormals& normals) {
  const auto missing = [](const auto& face) {
    return std::any_of(face.begin(), face.end(), [](const auto& n) { return n.isZero(); });
  };
  if (std::none_of(normals.begin(), normals.end(), missing)) return;
  const CornerNormals smooth = smooth_normals(mesh);
  for (size_t f = 0; f < normals.size(); ++f)
    for (int k = 0; k < 3; ++k)
      if (normals[f][k].isZero()) normals[f][k] = smooth[f][k];
}

}  // namespace trivet
