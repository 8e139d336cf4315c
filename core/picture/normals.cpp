#include "core/picture/normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

const double kCosCrease = std::cos(40.0 / 180 * 3.141592653589793);
// Comparing all faces around a vertex is quadratic; beyond this valence, faces keep their own
// normals.
constexpr std::size_t kMaxFacesAround = 512;

using Corners = std::array<Eigen::Vector3f, 3>;

/// Zero if the triangle has no area or is not finite.
std::vector<Vec3> face_normals(const PictureMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const Index3& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]];
    const Vec3 n = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    const double length = n.stableNorm();
    normals.push_back(length > 0 && std::isfinite(length) ? Vec3(n / length) : Vec3::Zero());
  }
  return normals;
}

/// A face at a vertex, and its angle there.
struct FaceAround {
  Index face;
  float angle;
};

/// Faces around each vertex, in the order of the faces: those of v are at [first[v], first[v + 1]).
struct FacesAround {
  std::vector<std::size_t> first;
  std::vector<FaceAround> faces;
};

float corner_angle(const PictureMesh& mesh, const Index3& t, int corner) {
  const Vec3 apex = mesh.vertices[t[corner]];
  const Vec3 a = mesh.vertices[t[(corner + 1) % 3]] - apex;
  const Vec3 b = mesh.vertices[t[(corner + 2) % 3]] - apex;
  return static_cast<float>(std::atan2(a.cross(b).norm(), a.dot(b)));
}

FacesAround faces_around(const PictureMesh& mesh) {
  FacesAround around;
  around.first.assign(mesh.vertices.size() + 1, 0);
  for (const Index3& t : mesh.triangles)
    for (const Index v : t) ++around.first[v + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) around.first[v + 1] += around.first[v];
  around.faces.resize(3 * mesh.triangles.size());
  std::vector<std::size_t> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int c = 0; c < 3; ++c)
      around.faces[next[mesh.triangles[f][c]]++] = {static_cast<Index>(f),
                                                    corner_angle(mesh, mesh.triangles[f], c)};
  return around;
}

Vec3 creased_normal(const std::vector<Vec3>& normals, const FacesAround& around, std::size_t face,
                    Index vertex) {
  const Vec3& own = normals[face];
  const std::size_t begin = around.first[vertex], end = around.first[vertex + 1];
  if (end - begin > kMaxFacesAround) return own;
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3& other = normals[around.faces[i].face];
    if (other.dot(own) >= kCosCrease) sum += other * around.faces[i].angle;
  }
  const double length = sum.norm();
  return length > 1e-12 && std::isfinite(length) ? Vec3(sum / length) : own;
}

Corners own_corners(const PictureMesh& mesh, const std::vector<Vec3>& normals,
                    const FacesAround& around, std::size_t face) {
  Corners corners;
  for (int c = 0; c < 3; ++c)
    corners[c] = creased_normal(normals, around, face, mesh.triangles[face][c]).cast<float>();
  return corners;
}

}  // namespace

std::vector<Corners> picture_normals(const PictureMesh& mesh) {
  const std::vector<Vec3> normals = face_normals(mesh);
  const bool given = mesh.corner_normals.size() == mesh.triangles.size();
  const FacesAround around = given ? FacesAround{} : faces_around(mesh);
  std::vector<Corners> corners(mesh.triangles.size());
  for (std::size_t f = 0; f < corners.size(); ++f) {
    if (!given) {
      corners[f] = own_corners(mesh, normals, around, f);
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      const Vec3 n = mesh.corner_normals[f][c].cast<double>();
      const double length = n.norm();
      const bool usable = length > 1e-12 && std::isfinite(length);
      corners[f][c] = (usable ? Vec3(n / length) : normals[f]).cast<float>();
    }
  }
  return corners;
}

}  // namespace trivet
