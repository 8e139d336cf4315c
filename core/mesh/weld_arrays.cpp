#include "core/mesh/weld_arrays.h"

#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/mesh/vertex_table.h"

namespace trivet {
namespace {

[[noreturn]] void fail(const Sentence& what, const Sentence& accepted) {
  throw Error(Error::Kind::BadInput, "%1; accepted: %2", what, accepted);
}

void check(std::span<const Vec3> vertices, std::span<const Index3> triangles) {
  constexpr size_t kMost = std::numeric_limits<Index>::max();
  if (triangles.empty()) fail("a mesh without triangles", "one at least");
  if (vertices.size() > kMost || triangles.size() > kMost)
    fail(say("a mesh of %1 vertices and %2 triangles", vertices.size(), triangles.size()),
         say("up to %1 of each", kMost));
  for (size_t v = 0; v < vertices.size(); ++v)
    if (!vertices[v].allFinite())
      fail(say("%1 is not finite", say("vertex %1", v)), "finite coordinates");
  for (size_t f = 0; f < triangles.size(); ++f)
    for (const Index v : triangles[f])
      if (v < 0 || static_cast<size_t>(v) >= vertices.size())
        fail(say("%1 has vertex %2", say("triangle %1", f), v),
             say("0 to %1", static_cast<long>(vertices.size()) - 1));
}

}  // namespace

WeldedMesh weld(std::span<const Vec3> vertices, std::span<const Index3> triangles) {
  check(vertices, triangles);
  // Vertices that no triangle names are not in the mesh.
  WeldedMesh out{{}, std::vector<Index>(vertices.size(), -1)};
  out.mesh.triangles.reserve(triangles.size());
  VertexTable table(out.mesh.vertices);
  for (const Index3& t : triangles) {
    for (const Index v : t)
      if (Index& id = out.new_id[static_cast<size_t>(v)]; id < 0)
        id = table.find_or_add(vertices[static_cast<size_t>(v)]);
    const auto new_id = [&](int k) { return out.new_id[static_cast<size_t>(t[k])]; };
    out.mesh.triangles.push_back({new_id(0), new_id(1), new_id(2)});
  }
  out.mesh.vertices.shrink_to_fit();
  return out;
}

}  // namespace trivet
