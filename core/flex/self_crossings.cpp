#include "core/flex/self_crossings.h"

#include <algorithm>

#include "core/base/float32.h"
#include "core/exact/predicates.h"
#include "core/flex/box_tree.h"

namespace trivet::flex {
namespace {

using Face = std::array<int, 3>;

bool has(const Face& face, int vertex) {
  return face[0] == vertex || face[1] == vertex || face[2] == vertex;
}

Triangle triangle(const Points& x, const Face& f) { return {x[f[0]], x[f[1]], x[f[2]]}; }

// The edge opposite a corner that both have, as a triangle without area, meets the other face.
bool meets_beyond(const Points& x, const Face& face, const Face& other) {
  int k = 0;
  while (!has(other, face[k])) ++k;
  const Vec3 &u = x[face[(k + 1) % 3]], &v = x[face[(k + 2) % 3]];
  return triangles_intersect({u, v, v}, triangle(x, other));
}

int side(const Vec3& a, const Vec3& b, const Vec3& p, int axis) {
  const auto flat = [&](const Vec3& v) { return Vec2(v[(axis + 1) % 3], v[(axis + 2) % 3]); };
  return orient2d(flat(a), flat(b), flat(p));
}

// Faces with a common edge overlap if they are in one plane and on one side of it.
bool are_folded(const Points& x, const Face& face, const Face& other) {
  int k = 0, m = 0;
  while (has(other, face[k])) ++k;
  while (has(face, other[m])) ++m;
  const Vec3 &a = x[face[(k + 1) % 3]], &b = x[face[(k + 2) % 3]], &p = x[face[k]],
             &q = x[other[m]];
  if (orient3d(a, b, p, q) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int of_p = side(a, b, p, axis), of_q = side(a, b, q, axis);
    if (of_p != 0 || of_q != 0) return of_p * of_q >= 0;
  }
  return true;
}

bool cross(const Points& x, const Face& a, const Face& b) {
  // Neighbours always touch where they share a corner or an edge: what counts is the rest of them.
  const auto shared = std::count_if(a.begin(), a.end(), [&](int v) { return has(b, v); });
  if (shared == 0) return triangles_intersect(triangle(x, a), triangle(x, b));
  if (shared == 1) return meets_beyond(x, a, b) || meets_beyond(x, b, a);
  return shared == 3 || are_folded(x, a, b);
}

}  // namespace

std::optional<FacePair> self_crossing(const Points& x, const std::vector<Face>& faces) {
  // The tree finds pairs whose boxes overlap; the first pair by numbers is named.
  std::vector<Aabb> boxes(faces.size());
  for (size_t f = 0; f < faces.size(); ++f)
    for (const int v : faces[f]) boxes[f].extend(x[v]);
  const BoxTree tree(boxes);
  for (size_t f = 0; f < faces.size(); ++f) {
    const int a = static_cast<int>(f);
    int least = -1;
    tree.visit(boxes[f], [&](int b) {
      if (b > a && (least < 0 || b < least) && cross(x, faces[a], faces[b])) least = b;
    });
    if (least >= 0) return FacePair{a, least};
  }
  return std::nullopt;
}

Points rounded_to_float32(const Points& x) {
  Points out;
  out.reserve(x.size());
  for (const Vec3& p : x) out.push_back(as_float32(p));
  return out;
}

}  // namespace trivet::flex
