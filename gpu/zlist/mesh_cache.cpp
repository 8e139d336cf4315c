#include "gpu/zlist/mesh_cache.h"

#include <algorithm>
#include <vector>

namespace trivet {
namespace {

constexpr std::size_t kItemBytes = 12;  // of a vertex, and of a face

std::size_t bytes_of(const Mesh& mesh) {
  return kItemBytes * (mesh.vertices.size() + mesh.triangles.size());
}

GpuMesh send(const Shape& shape) {
  // Positions are sent about the box's centre, where float32 is finest.
  const Vec3 centre = shape.box.centre();
  std::vector<float> vertices;
  std::vector<std::uint32_t> corners;
  for (const Vec3& v : shape.mesh.vertices)
    for (int k = 0; k < 3; ++k) vertices.push_back(static_cast<float>(v[k] - centre[k]));
  for (const Index3& t : shape.mesh.triangles)
    for (const Index v : t) corners.push_back(static_cast<std::uint32_t>(v));
  GpuMesh out;
  out.num_faces = static_cast<GLsizei>(shape.mesh.triangles.size());
  out.bytes = bytes_of(shape.mesh);
  out.vertex_array = GlVertexArray::create();
  glBindVertexArray(out.vertex_array.id());
  out.vertices = make_buffer(GL_ARRAY_BUFFER, vertices.data(), vertices.size() * sizeof(float));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  out.corners =
      make_buffer(GL_ELEMENT_ARRAY_BUFFER, corners.data(), corners.size() * sizeof(std::uint32_t));
  glBindVertexArray(0);
  return out;
}

}  // namespace

bool ZListMeshCache::make_room(std::size_t bytes) {
  // The mesh that has not been used for longest goes first; those of this query stay.
  while (m_bytes + bytes > m_max_bytes) {
    const auto oldest = std::min_element(
        m_meshes.begin(), m_meshes.end(),
        [](const auto& a, const auto& b) { return a.second.last_query < b.second.last_query; });
    if (oldest == m_meshes.end() || oldest->second.last_query == m_query) return false;
    m_bytes -= oldest->second.mesh.bytes;
    m_meshes.erase(oldest);
  }
  return true;
}

const GpuMesh* ZListMeshCache::get(const Shape& shape) {
  // Shapes without an id are sent for this query and never found again.
  const std::uint64_t id = shape.id != 0 ? shape.id : m_next_unnamed--;
  const auto known = m_meshes.find(id);
  if (known != m_meshes.end()) {
    known->second.last_query = m_query;
    return &known->second.mesh;
  }
  // A mesh beyond the driver's limit is not sent at all.
  const std::size_t num_items = std::max(shape.mesh.vertices.size(), shape.mesh.triangles.size());
  if (kItemBytes * num_items > m_max_buffer_bytes) return nullptr;
  if (!make_room(bytes_of(shape.mesh))) return nullptr;
  Slot& slot = m_meshes[id];
  slot = {send(shape), m_query};
  m_bytes += slot.mesh.bytes;
  return &slot.mesh;
}

}  // namespace trivet
