// Private to gpu: cache of meshes in graphics memory.
#pragma once

#include <cstdint>
#include <map>

#include "core/index/shape.h"
#include "gpu/egl/gl_objects.h"

namespace trivet {

struct GpuMesh {
  GlBuffer vertices;  // float x y z, about the centre of the shape's box
  GlBuffer corners;   // uint32, three per face
  GlVertexArray vertex_array;
  GLsizei num_faces = 0;
  std::size_t bytes = 0;
};

/// Meshes by the identity of their shapes; the least recently used go first. Shapes without
/// identity are uploaded every time. Needs a current context.
class ZListMeshCache {
 public:
  /// @param max_buffer_bytes  of the vertices, or of the faces, of one mesh.
  ZListMeshCache(std::size_t max_bytes, std::size_t max_buffer_bytes)
      : m_max_bytes(max_bytes), m_max_buffer_bytes(max_buffer_bytes) {}

  /// Meshes used from now on stay until the next call.
  void begin_query() { ++m_query; }
  /// @return null if the meshes of this query together, or this one, do not fit.
  /// @throws Error (Environment) when OpenGL fails.
  const GpuMesh* get(const Shape& shape);
  std::size_t num_bytes() const { return m_bytes; }
  std::size_t num_meshes() const { return m_meshes.size(); }

 private:
  struct Slot {
    GpuMesh mesh;
    std::uint64_t last_query = 0;
  };
  bool make_room(std::size_t bytes);

  std::map<std::uint64_t, Slot> m_meshes;  // by Shape::id
  std::size_t m_max_bytes, m_max_buffer_bytes, m_bytes = 0;
  std::uint64_t m_query = 0;
  std::uint64_t m_next_unnamed = ~std::uint64_t{0};  // counts down; for shapes without identity
};

}  // namespace trivet
