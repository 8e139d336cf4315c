#include "core/io/assimp/geometry.h"

#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <sstream>

#include "core/base/bad_input.h"
#include "core/io/mesh/normals.h"

namespace trivet {
namespace {

constexpr double kMaxCoordinate = 1e30;  // squares and cubes of it stay finite in double

/// Row by row; the bottom row matters only in products, as files may store anything there.
using Matrix4 = std::array<std::array<double, 4>, 4>;

Matrix4 matrix_of(const aiNode& node) {
  Matrix4 out;
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c) out[r][c] = node.mTransformation[r][c];
  return out;
}

Matrix4 identity() { return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}; }

// Sums from left to right, as Eigen's packet product does on every x86-64.
Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 out;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      double sum = a[r][0] * b[0][c];
      for (int k = 1; k < 4; ++k) sum += a[r][k] * b[k][c];
      out[r][c] = sum;
    }
  return out;
}

Affine affine_of(const Matrix4& m) {
  Affine out;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.linear(r, c) = m[r][c];
    out.translation[r] = m[r][3];
  }
  return out;
}

/// A mesh of the file as instanced by one node.
struct Instance {
  const aiMesh* mesh;
  const aiNode* node;
  Affine object_from_mesh;
};

using Corners = std::array<unsigned, 3>;  // of a triangle, vertices of its mesh

/// Counts of file contents that the model omits.
struct LeftOut {
  std::int64_t points = 0, lines = 0, polygons = 0;
  int skinned = 0, mirrored = 0;
};

// Depth first, children in order; no recursion, as a hostile file may nest deeply.
std::vector<Instance> instances_of(const aiScene& scene, Model& model) {
  std::vector<Instance> instances;
  std::vector<std::pair<const aiNode*, Matrix4>> stack{{scene.mRootNode, identity()}};
  while (!stack.empty()) {
    const auto [node, object_from_parent] = stack.back();
    stack.pop_back();
    ++model.num_nodes;
    const Matrix4 object_from_node = product(object_from_parent, matrix_of(*node));
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const unsigned id = node->mMeshes[i];
      if (id >= scene.mNumMeshes)
        throw Error(Error::Kind::BadInput, "%1: node '%2' refers to mesh %3 of %4", model.path,
                    node->mName.C_Str(), id, scene.mNumMeshes);
      instances.push_back({scene.mMeshes[id], node, affine_of(object_from_node)});
    }
    for (unsigned i = node->mNumChildren; i-- > 0;)
      stack.emplace_back(node->mChildren[i], object_from_node);
  }
  return instances;
}

std::int64_t count_triangles(const std::vector<Instance>& instances) {
  std::int64_t count = 0;
  for (const Instance& instance : instances) count += instance.mesh->mNumFaces;
  return count;
}

std::string coordinates(const aiVector3D& v) {
  std::ostringstream out;
  out.precision(9);
  out << "(" << v.x << ", " << v.y << ", " << v.z << ")";
  return out.str();
}

class Reader {
 public:
  Reader(const aiScene& scene, Model& model) : m_scene(scene), m_model(model) {}

  void read(const std::vector<Instance>& instances) {
    for (const Instance& instance : instances) read(instance);
    note_left_out();
  }
  bool has_normals() const { return m_has_normals; }
  std::vector<Triangle>& triangles() { return m_triangles; }

 private:
  void read(const Instance& instance) {
    const aiMesh& mesh = *instance.mesh;
    const Mat3 linear = instance.object_from_mesh.linear;
    // Cofactors are the inverse transpose times the determinant: only its sign remains to be
    // applied.
    const double sign = linear.determinant() < 0 ? -1.0 : 1.0;
    Mat3 normal_matrix;
    for (int r = 0; r < 3; ++r)
      normal_matrix.row(r) = sign * linear.row((r + 1) % 3).cross(linear.row((r + 2) % 3));
    survey(mesh, sign < 0);
    const Index material =
        mesh.mMaterialIndex < m_scene.mNumMaterials ? static_cast<Index>(mesh.mMaterialIndex) : 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) {
        ++(face.mNumIndices < 2    ? m_left_out.points
           : face.mNumIndices == 2 ? m_left_out.lines
                                   : m_left_out.polygons);
        continue;
      }
      const Corners corners = corners_of(face, sign < 0);
      read_corners(instance, corners);
      read_normals(mesh, corners, normal_matrix);
      m_model.face_material.push_back(material);
    }
  }

  void survey(const aiMesh& mesh, bool mirrored) {
    m_left_out.skinned += mesh.HasBones();
    m_left_out.mirrored += mirrored;
  }

  // A mirror turns inside and outside round; so does the order of the corners.
  static Corners corners_of(const aiFace& face, bool mirrored) {
    return {face.mIndices[0], face.mIndices[mirrored ? 2 : 1], face.mIndices[mirrored ? 1 : 2]};
  }

  void read_corners(const Instance& instance, const Corners& corners) {
    const aiMesh& mesh = *instance.mesh;
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      const unsigned v = corners[k];
      const aiVector3D& p = mesh.mVertices[v];
      triangle[k] = instance.object_from_mesh.apply(Vec3(p.x, p.y, p.z));
      if (!triangle[k].allFinite())
        fail(instance, say("vertex %1 %2 is not finite%3", v, coordinates(p), after_node(p)));
      if (triangle[k].cwiseAbs().maxCoeff() > kMaxCoordinate)
        fail(instance, say("vertex %1 %2 lies beyond 1e30%3", v, coordinates(p), after_node(p)));
    }
    m_triangles.push_back(triangle);
  }

  static Sentence after_node(const aiVector3D& p) {
    const bool own_fault = !(std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
                             std::abs(p.z) <= kMaxCoordinate);
    return own_fault ? Sentence() : Sentence(" after the transform of its node");
  }

  [[noreturn]] void fail(const Instance& instance, const Sentence& what) const {
    const std::string mesh = instance.mesh->mName.C_Str(), node = instance.node->mName.C_Str();
    throw Error(Error::Kind::BadInput, "%1: mesh '%2': %3", m_model.path,
                (mesh.empty() ? node : mesh), what);
  }

  // The zero vector stands for a missing normal until fill_missing_normals().
  void read_normals(const aiMesh& mesh, const Corners& corners, const Mat3& normal_matrix) {
    std::array<Eigen::Vector3f, 3> normals;
    normals.fill(Eigen::Vector3f::Zero());
    for (int k = 0; mesh.HasNormals() && k < 3; ++k) {
      const aiVector3D& n = mesh.mNormals[corners[k]];
      const Vec3 turned = normal_matrix * Vec3(n.x, n.y, n.z);
      const double length = turned.norm();
      if (!std::isfinite(length) || length == 0) continue;
      normals[k] = (turned / length).cast<float>();
      m_has_normals = true;
    }
    m_model.corner_normals.push_back(normals);
  }

  void note(const Sentence& what, std::int64_t count) {
    if (count > 0) m_model.notes.push_back(say("%1: %2", what, count));
  }

  void note_left_out() {
    note("points left out", m_left_out.points);
    note("lines left out", m_left_out.lines);
    note("polygons left out, as they could not be triangulated", m_left_out.polygons);
    note("meshes with bones, read in bind pose", m_left_out.skinned);
    note("mirrored meshes, winding turned round", m_left_out.mirrored);
  }

  const aiScene& m_scene;
  Model& m_model;
  std::vector<Triangle> m_triangles;
  LeftOut m_left_out;
  bool m_has_normals = false;
};

}  // namespace

void read_geometry(const aiScene& scene, const ImportLimits& limits, Model& model) {
  const std::vector<Instance> instances = instances_of(scene, model);
  const std::int64_t count = count_triangles(instances);
  if (count > limits.max_triangles)
    throw Error(Error::Kind::BadInput, "%1: %2 faces, more than the limit of %3", model.path, count,
                limits.max_triangles);
  Reader reader(scene, model);
  reader.triangles().reserve(count);
  model.face_material.reserve(count);
  model.corner_normals.reserve(count);
  reader.read(instances);
  if (reader.triangles().empty())
    bad_file(model.path, model.notes.empty()
                             ? "contains no triangle"
                             : say("contains no triangle (%1)", model.notes.front()));
  model.mesh = weld(reader.triangles());
  // Normals of an STL only repeat the facets, and often wrongly.
  if (reader.has_normals() && model.format != "stl")
    fill_missing_normals(model.mesh, model.corner_normals);
  else
    model.corner_normals.clear();
}

}  // namespace trivet
