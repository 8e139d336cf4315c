#include "core/io/assimp/polygons.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/exact/triangulate.h"
#include "core/io/surface/coordinate_limit.h"

namespace trivet {
namespace {

std::vector<Vec3> corners_of_face(const aiMesh& mesh, const aiFace& face) {
  std::vector<Vec3> out;
  for (unsigned k = 0; k < face.mNumIndices; ++k) {
    const aiVector3D& p = mesh.mVertices[face.mIndices[k]];
    out.emplace_back(p.x, p.y, p.z);
  }
  return out;
}

bool can_be_cut(const std::vector<Vec3>& corners) {
  return std::all_of(corners.begin(), corners.end(), [](const Vec3& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate;
  });
}

// Coordinates beyond the limit are refused when they are read.
bool cut(const std::vector<Vec3>& corners, std::vector<Index3>& triangles) {
  if (can_be_cut(corners)) return triangulate(corners, triangles);
  for (Index i = 1; i + 1 < static_cast<Index>(corners.size()); ++i)
    triangles.push_back({0, i, i + 1});
  return true;
}

aiFace triangle_of(const aiFace& face, const Index3& t) {
  aiFace out;
  out.mNumIndices = 3;
  out.mIndices = new unsigned[3];
  for (int k = 0; k < 3; ++k) out.mIndices[k] = face.mIndices[t[static_cast<size_t>(k)]];
  return out;
}

std::int64_t triangulate_mesh(aiMesh& mesh) {
  const auto is_polygon = [](const aiFace& face) { return face.mNumIndices > 3; };
  if (std::none_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, is_polygon)) return 0;
  std::vector<aiFace> faces;
  std::vector<Index3> triangles;
  std::int64_t num_fans = 0;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    triangles.clear();
    if (is_polygon(face)) num_fans += !cut(corners_of_face(mesh, face), triangles);
    if (triangles.empty()) faces.push_back(face);
    for (const Index3& t : triangles) faces.push_back(triangle_of(face, t));
  }
  delete[] mesh.mFaces;
  mesh.mNumFaces = static_cast<unsigned>(faces.size());
  mesh.mFaces = new aiFace[faces.size()];
  std::move(faces.begin(), faces.end(), mesh.mFaces);
  return num_fans;
}

}  // namespace

std::int64_t triangulate_polygons(aiScene& scene) {
  std::int64_t num_fans = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) num_fans += triangulate_mesh(*scene.mMeshes[m]);
  return num_fans;
}

}  // namespace trivet
