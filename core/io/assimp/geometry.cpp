#include "core/io/assimp/geometry.h"

#include <assimp/scene.h>

#include "core/base/error.h"
#include "core/io/mesh/assembly.h"
#include "core/io/mesh/node_product.h"
#include "core/io/surface/file_surface.h"

namespace trivet {
namespace {

Matrix4 matrix_of(const aiNode& node) {
  Matrix4 out;
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c) out[r][c] = node.mTransformation[r][c];
  return out;
}

/// A mesh of the file as instanced by one node.
struct Instance {
  const aiMesh* mesh;
  const aiNode* node;
  Affine object_from_mesh;
};

/// Counts of file contents that the model omits.
struct LeftOut {
  std::int64_t points = 0, lines = 0, polygons = 0;
  int skinned = 0, mirrored = 0, flat = 0;
};

// Only matrices that are affine keep planes of triangles, and parallels.
bool is_affine_node(const aiNode& node) {
  const aiMatrix4x4& m = node.mTransformation;
  return m.d1 == 0 && m.d2 == 0 && m.d3 == 0 && m.d4 == 1;
}

// Depth first, children in order; no recursion, as a hostile file may nest deeply.
std::vector<Instance> instances_of(const aiScene& scene, Model& model) {
  std::vector<Instance> instances;
  std::vector<std::pair<const aiNode*, Matrix4>> stack{{scene.mRootNode, identity_matrix4()}};
  std::int64_t num_odd = 0;
  while (!stack.empty()) {
    const auto [node, object_from_parent] = stack.back();
    stack.pop_back();
    ++model.num_nodes;
    num_odd += !is_affine_node(*node);
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
  note_count(model.notes, "last rows of matrices that are not 0 0 0 1, left out", num_odd);
  return instances;
}

std::int64_t count_triangles(const std::vector<Instance>& instances) {
  std::int64_t count = 0;
  for (const Instance& instance : instances) count += instance.mesh->mNumFaces;
  return count;
}

std::span<const Eigen::Vector3f> rows(const aiVector3D* first, unsigned count) {
  static_assert(sizeof(aiVector3D) == sizeof(Eigen::Vector3f));
  return {reinterpret_cast<const Eigen::Vector3f*>(first), first ? count : 0};
}

MeshVertices vertices_of(const Instance& instance) {
  const aiMesh& mesh = *instance.mesh;
  return {mesh.mName.length ? mesh.mName.C_Str() : instance.node->mName.C_Str(),
          rows(mesh.mVertices, mesh.mNumVertices), rows(mesh.mNormals, mesh.mNumVertices)};
}

class Reader {
 public:
  Reader(const aiScene& scene, const ImportLimits& limits, Model& model)
      : m_scene(scene), m_model(model), m_assembly(model, limits) {}

  void read(const std::vector<Instance>& instances) {
    m_assembly.expect(static_cast<std::uint64_t>(count_triangles(instances)));
    for (const Instance& instance : instances) read(instance);
    note_left_out();
    // Normals of an STL only repeat the facets, and often wrongly.
    m_assembly.finish(m_model.format != "stl");
  }

 private:
  void read(const Instance& instance) {
    const aiMesh& mesh = *instance.mesh;
    m_left_out.skinned += mesh.HasBones();
    m_left_out.mirrored += mirrors(instance.object_from_mesh);
    m_left_out.flat += flattens(instance.object_from_mesh);
    m_assembly.place(vertices_of(instance), instance.object_from_mesh);
    const Index material =
        mesh.mMaterialIndex < m_scene.mNumMaterials ? static_cast<Index>(mesh.mMaterialIndex) : 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 3)
        m_assembly.add({face.mIndices[0], face.mIndices[1], face.mIndices[2]}, material);
      else
        ++(face.mNumIndices < 2    ? m_left_out.points
           : face.mNumIndices == 2 ? m_left_out.lines
                                   : m_left_out.polygons);
    }
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
    note("meshes without volume, as their transform flattens them", m_left_out.flat);
  }

  const aiScene& m_scene;
  Model& m_model;
  ModelAssembly m_assembly;
  LeftOut m_left_out;
};

}  // namespace

void read_geometry(const aiScene& scene, const ImportLimits& limits, Model& model) {
  Reader(scene, limits, model).read(instances_of(scene, model));
}

}  // namespace trivet
