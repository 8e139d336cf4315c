#include "core/mesh/mesh.h"

#include "core/mesh/vertex_table.h"

namespace trivet {

Aabb Mesh::box() const {
  Aabb box;
  for (const Vec3& p : vertices) box.extend(p);
  return box;
}

Mesh weld(const std::vector<Triangle>& triangles) {
  Mesh mesh;
  mesh.triangles.reserve(triangles.size());
  VertexTable table(mesh.vertices);
  for (const Triangle& t : triangles) {
    const Index a = table.find_or_add(t[0]), b = table.find_or_add(t[1]);
    mesh.triangles.push_back({a, b, table.find_or_add(t[2])});
  }
  mesh.vertices.shrink_to_fit();
  return mesh;
}

}  // namespace trivet
