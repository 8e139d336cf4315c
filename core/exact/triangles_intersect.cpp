// Intersection of two closed triangles, decided by signs of determinants alone.
//
// In general position both triangles cut the line where their planes meet, each in an interval
// between two of its edges; one orient3d() compares an end of either [Guigue 2003].
// Departs from the source: all four pairs of ends are compared, instead of sorting the ends first;
// that is two signs more in the rare worst case, and no permutations.
//
// Legend: side, the sign of orient3d(plane of a triangle, point).
#include <algorithm>
#include <array>
#include <optional>

#include "core/exact/orientation_stages.h"
#include "core/exact/predicates.h"

namespace trivet {
namespace {

using Signs = std::array<int, 3>;

inline int sign_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::optional<int> sign = orient3d_filter(a, b, c, d);
  return sign ? *sign : orient3d_exact(a, b, c, d);
}

bool boxes_overlap(const Triangle& a, const Triangle& b) {
  bool overlap = true;  // branchless: the signs cannot be predicted
  for (int k = 0; k < 3; ++k) {
    const double a_lower = std::min(std::min(a[0][k], a[1][k]), a[2][k]);
    const double a_upper = std::max(std::max(a[0][k], a[1][k]), a[2][k]);
    const double b_lower = std::min(std::min(b[0][k], b[1][k]), b[2][k]);
    const double b_upper = std::max(std::max(b[0][k], b[1][k]), b[2][k]);
    overlap &= a_lower <= b_upper;
    overlap &= b_lower <= a_upper;
  }
  return overlap;
}

Signs sides(const Triangle& plane, const Triangle& points) {
  Signs out;
  for (int k = 0; k < 3; ++k) out[k] = sign_of(plane[0], plane[1], plane[2], points[k]);
  return out;
}

bool all_equal(const Signs& s) { return s[0] == s[1] && s[1] == s[2]; }

// Corner whose two edges cut or touch the plane, both crossing it the same way: strictly above both
// other corners, or strictly below. Exists unless all sides are the same.
int apex(const Signs& s) {
  for (int k = 0; k < 2; ++k) {
    const int to_next = s[k] - s[(k + 1) % 3], to_last = s[k] - s[(k + 2) % 3];
    if ((to_next > 0 && to_last > 0) || (to_next < 0 && to_last < 0)) return k;
  }
  return 2;
}

// For triangles that do not lie in each other's plane. The two intervals on the line are apart if
// both ends of one come before both ends of the other: four equal signs.
bool intervals_overlap(const Triangle& a, const Signs& sides_a, const Triangle& b,
                       const Signs& sides_b) {
  // An apex has the common line between itself and its other corners; its two edges end the
  // interval.
  const int apex_a = apex(sides_a), apex_b = apex(sides_b);
  int first = 0;
  for (int i = 1; i <= 2; ++i)
    for (int j = 1; j <= 2; ++j) {
      // The sign tells which end comes first on the common line; two different ones, or a zero,
      // mean overlap.
      const int sign = sign_of(a[apex_a], a[(apex_a + i) % 3], b[apex_b], b[(apex_b + j) % 3]);
      if (sign == 0 || sign == -first) return true;
      first = sign;
    }
  return false;
}

// -------------------------------------------------------------------------------------------------
// Coplanar and degenerate triangles
// -------------------------------------------------------------------------------------------------

// Triangle by its dimension: its first 1, 2 or 3 corners.
struct Simplex {
  int size;
  Triangle corners;
};

// Drops one axis.
Vec2 projected(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

// An axis along which the three points can be projected without becoming collinear, if any.
std::optional<int> projection_axis(const Vec3& p, const Vec3& q, const Vec3& r) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(projected(p, axis), projected(q, axis), projected(r, axis)) != 0) return axis;
  return std::nullopt;
}

bool comes_before(const Vec3& p, const Vec3& q) {
  return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

Simplex simplex_of(const Triangle& t) {
  // Without area it is a segment between its lexicographic ends, or a point.
  if (projection_axis(t[0], t[1], t[2])) return {3, t};
  const auto [lowest, highest] = std::minmax({t[0], t[1], t[2]}, comes_before);
  return {lowest == highest ? 1 : 2, {lowest, highest, highest}};
}

// On a line, the order of the points is the lexicographic one.
bool collinear_intersect(const Simplex& a, const Simplex& b) {
  return !comes_before(a.corners[2], b.corners[0]) && !comes_before(b.corners[2], a.corners[0]);
}

// In the plane: whether the line of an edge of a has a on one side (or on it) and b strictly on the
// other.
bool edge_separates(const Simplex& a, const Simplex& b, int axis) {
  const auto point = [&](const Simplex& s, int k) { return projected(s.corners[k % 3], axis); };
  const int num_edges = a.size == 3 ? 3 : a.size - 1;
  for (int i = 0; i < num_edges; ++i) {
    const Vec2 from = point(a, i), to = point(a, i + 1);
    // The inside of the edge is where the third corner lies.
    const int own = a.size == 3 ? orient2d(from, to, point(a, i + 2)) : 0;
    const int other = orient2d(from, to, point(b, 0));
    // Every corner of the other set has to lie strictly beyond the edge.
    bool apart = other != 0 && other != own;
    for (int k = 1; k < b.size; ++k) apart = apart && orient2d(from, to, point(b, k)) == other;
    if (apart) return true;
  }
  return false;
}

// For corners in one plane; a has at least as many as b. Separating axes are normals of edges: the
// difference of both sets has an interior, unless all is on one line.
bool coplanar_intersect(const Simplex& a, const Simplex& b) {
  const Triangle &p = a.corners, &q = b.corners;
  // A plane needs three corners that are not on one line, of one set or of both.
  std::optional<int> axis = projection_axis(p[0], p[1], p[2]);
  for (int k = 0; k < 3 && !axis; ++k) axis = projection_axis(p[0], p[1], q[k]);
  if (!axis) return collinear_intersect(a, b);
  return !edge_separates(a, b, *axis) && !edge_separates(b, a, *axis);
}

// Segment with its ends on different sides of the triangle's plane, or one end on it.
bool segment_pierces(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Signs turns = {sign_of(p, q, t[0], t[1]), sign_of(p, q, t[1], t[2]),
                       sign_of(p, q, t[2], t[0])};
  const auto [lowest, highest] = std::minmax_element(turns.begin(), turns.end());
  return *lowest >= 0 || *highest <= 0;
}

bool simplices_intersect(const Simplex& a, const Simplex& b) {
  if (a.size < b.size) return simplices_intersect(b, a);
  const Triangle &p = a.corners, &q = b.corners;
  if (a.size == 3 && b.size < 3) {
    // A triangle against less: the plane tells which case it is.
    const Signs s = sides(p, q);
    // Both ends on one side never touch the plane; on different sides the segment pierces it,
    // inside the triangle or not.
    if (s[0] * s[1] > 0) return false;
    if (s[0] != s[1]) return segment_pierces(q[0], q[1], p);
  }
  // Two segments that span space cannot meet.
  if (a.size == 2 && sign_of(p[0], p[1], q[0], q[1]) != 0) return false;
  return coplanar_intersect(a, b);
}

}  // namespace

bool triangles_intersect(const Triangle& a, const Triangle& b) {
  // Boxes reject most pairs; the planes reject most of the rest.
  if (!boxes_overlap(a, b)) return false;
  const Signs sides_b = sides(a, b);
  if (all_equal(sides_b) && sides_b[0] != 0) return false;
  const Signs sides_a = sides(b, a);
  if (all_equal(sides_a) && sides_a[0] != 0) return false;
  // All 0: coplanar, or the triangle of the plane is degenerate.
  if (all_equal(sides_a) || all_equal(sides_b))
    return simplices_intersect(simplex_of(a), simplex_of(b));
  return intervals_overlap(a, sides_a, b, sides_b);
}

}  // namespace trivet
