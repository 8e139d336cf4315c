#include "core/scene/collision_mesh.h"

#include <cstring>

#include "core/scene/object.h"

namespace trivet {
namespace {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

bool has_collision_mesh(const Object& object) {
  if (!object.model) return false;
  const Mesh &judged = object.shape->mesh, &drawn = object.model->mesh;
  return !same_bytes(judged.triangles, drawn.triangles) ||
         !same_bytes(judged.vertices, drawn.vertices);
}

}  // namespace trivet
