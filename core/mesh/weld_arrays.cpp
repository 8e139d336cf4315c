#include "core/mesh/weld_arrays.h"

#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/mesh/vertex_table.h"

namespace trivet {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& accepted) {
  throw Error(Error::Kind::BadInput, what + "; accepted: " + accepted);
}

std::string row(const char* what, size_t number) {
  return std::string(what) + " " + std::to_string(number);
}

void check(std::span<const Vec3> vertices, std::span<const Index3> triangles) {
  constexpr size_t kMost = std::numeric_limits<Index>::max();
  if (triangles.empty()) fail("a mesh without triangles", "one at least");
  if (vertices.size() > kMost || triangles.size() > kMost)
    fail("a mesh of " + std::to_string(vertices.size()) + " vertices and " +
             std::to_string(triangles.size()) + " triangles",
         "up to " + std::to_string(kMost) + " of each");
  for (size_t v = 0; v < vertices.size(); ++v)
    if (!vertices[v].allFinite()) fail(row("vertex", v) + " is not finite", "finite coordinates");
  for (size_t f = 0; f < triangles.size(); ++f)
    for (const Index v : triangles[f])
      if (v < 0 || static_cast<size_t>(v) >= vertices.size())
        fail(row("triangle", f) + " has vertex " + std::to_string(v),
             "0 to " + std::to_string(static_cast<long>(vertices.size()) - 1));
}

}  // namespace

WeldedMesh weld(std::span<const Vec3> vertices, std::span<const Index3> triangles) {
  check(vertices, triangles);
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
