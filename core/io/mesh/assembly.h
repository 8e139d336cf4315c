// Models put together from the meshes of a file, wherever its nodes place them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

/// Vertices of a mesh, float32, in its own frame.
struct MeshVertices {
  std::string name;                            // for messages
  std::span<const Eigen::Vector3f> positions;  // #V
  std::span<const Eigen::Vector3f> normals;    // #V, or empty
};

/// Fills mesh, face_material and corner_normals of a model, triangle by triangle. Positions are
/// those of the file times the transform, in double: programs that do the same get the same bits.
class ModelAssembly {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  ModelAssembly(Model& model, const ImportLimits& limits) : m_model(model), m_limits(limits) {}

  /// Room for so many triangles. @throws Error (BadInput): more than the limit.
  void expect(std::uint64_t num_triangles);
  /// The triangles that follow have these vertices, placed so. They have to live until the next.
  void place(const MeshVertices& mesh, const Affine& object_from_mesh);
  /// Ids of vertices, in range. Below a mirror, corners 1 and 2 change places: it turns inside and
  /// outside round. @throws Error (BadInput): a coordinate that is not finite, or beyond 1e30.
  void add(const Corners& corners, Index material);

  /// Welds what was added. @param keeps_normals  false: those of the file are not to be trusted.
  /// @throws Error (BadInput): no triangle.
  void finish(bool keeps_normals);

 private:
  struct Placed {
    std::uint32_t placement = 0;  // the last one that used it
    Index id = -1;                // of m_vertices
    Eigen::Vector3f normal;       // unit, or zero
  };

  const Placed& placed(std::uint32_t vertex);
  void check(std::uint32_t vertex, const Vec3& point) const;
  Eigen::Vector3f placed_normal(std::uint32_t vertex) const;

  Model& m_model;
  const ImportLimits& m_limits;
  MeshVertices m_mesh;
  Affine m_object_from_mesh;
  Mat3 m_normal_matrix = Mat3::Identity();
  bool m_mirrored = false, m_has_normals = false;
  std::uint32_t m_placement = 0;
  std::vector<Placed> m_placed;
  std::vector<Vec3> m_vertices;
  std::vector<Index3> m_triangles;
};

}  // namespace trivet
