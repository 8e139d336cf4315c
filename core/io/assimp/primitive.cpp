#include "core/io/assimp/primitive.h"

#include <algorithm>

#include "core/io/colour.h"
#include "core/io/gltf/row_set.h"
#include "core/io/mesh/normals.h"

namespace trivet {
namespace {

bool is_triangle(const aiFace& face) { return face.mNumIndices == 3; }

/// One mesh of assimp as a primitive of glTF.
class PrimitiveMaker {
 public:
  explicit PrimitiveMaker(const aiMesh& mesh) : m_mesh(mesh) {
    if (!mesh.HasNormals()) m_smooth = smooth();
  }

  GltfJson make(GltfBuilder& builder) const {
    const std::vector<unsigned> sets = coordinate_sets();
    const bool coloured = m_mesh.HasVertexColors(0);
    RowSet rows(6 + 2 * sets.size() + (coloured ? 4 : 0));
    std::vector<std::uint32_t> indices;
    std::vector<float> row;
    for (unsigned f = 0, triangle = 0; f < m_mesh.mNumFaces; ++f) {
      if (!is_triangle(m_mesh.mFaces[f])) continue;
      for (int k = 0; k < 3; ++k) {
        fill(row, m_mesh.mFaces[f].mIndices[k], triangle, k, sets, coloured);
        indices.push_back(rows.add(row));
      }
      ++triangle;
    }
    GltfJson attributes = {{"POSITION", builder.add_positions(rows.columns(0, 3))},
                           {"NORMAL", builder.add_floats(rows.columns(3, 3), 3)}};
    for (size_t i = 0; i < sets.size(); ++i)
      attributes["TEXCOORD_" + std::to_string(i)] =
          builder.add_floats(rows.columns(6 + 2 * i, 2), 2);
    if (coloured)
      attributes["COLOR_0"] = builder.add_floats(rows.columns(6 + 2 * sets.size(), 4), 4);
    return {{"attributes", std::move(attributes)}, {"indices", builder.add_indices(indices)}};
  }

 private:
  std::vector<unsigned> coordinate_sets() const {
    std::vector<unsigned> sets;
    while (sets.size() < AI_MAX_NUMBER_OF_TEXTURECOORDS &&
           m_mesh.HasTextureCoords(static_cast<unsigned>(sets.size())))
      sets.push_back(static_cast<unsigned>(sets.size()));
    return sets;
  }

  CornerNormals smooth() const {
    std::vector<Triangle> triangles;
    const auto position = [&](unsigned v) {
      const aiVector3D& p = m_mesh.mVertices[v];
      return Vec3(p.x, p.y, p.z);
    };
    for (unsigned f = 0; f < m_mesh.mNumFaces; ++f)
      if (const aiFace& face = m_mesh.mFaces[f]; is_triangle(face))
        triangles.push_back(
            {position(face.mIndices[0]), position(face.mIndices[1]), position(face.mIndices[2])});
    return smooth_normals(weld(triangles));
  }

  Eigen::Vector3f normal(unsigned vertex, unsigned triangle, int corner) const {
    if (!m_smooth.empty()) return m_smooth[triangle][static_cast<size_t>(corner)];
    const aiVector3D& n = m_mesh.mNormals[vertex];
    const Vec3 given(n.x, n.y, n.z);
    const double length = given.norm();
    if (!std::isfinite(length) || length == 0) return Eigen::Vector3f::UnitZ();
    return (given / length).cast<float>();
  }

  void fill(std::vector<float>& row, unsigned v, unsigned triangle, int corner,
            const std::vector<unsigned>& sets, bool coloured) const {
    const aiVector3D& p = m_mesh.mVertices[v];
    const Eigen::Vector3f n = normal(v, triangle, corner);
    row = {p.x, p.y, p.z, n.x(), n.y(), n.z()};
    for (const unsigned set : sets) {
      const aiVector3D& t = m_mesh.mTextureCoords[set][v];
      row.push_back(finite_or_zero(t.x));
      row.push_back(finite_or_zero(1 - t.y));  // v runs up in assimp and down in glTF
    }
    if (!coloured) return;
    const aiColor4D& c = m_mesh.mColors[0][v];
    for (const float part : {c.r, c.g, c.b}) row.push_back(linear_from_srgb(finite_or_zero(part)));
    row.push_back(std::isfinite(c.a) ? std::clamp(c.a, 0.0f, 1.0f) : 1.0f);
  }

  const aiMesh& m_mesh;
  CornerNormals m_smooth;  // of the triangles; empty: use the file's normals
};

}  // namespace

bool has_triangles(const aiMesh& mesh) {
  return std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, is_triangle);
}

GltfJson primitive_of_assimp(const aiMesh& mesh, GltfBuilder& builder) {
  return PrimitiveMaker(mesh).make(builder);
}

}  // namespace trivet
