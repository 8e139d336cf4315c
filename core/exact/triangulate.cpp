#include "core/exact/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

#include "core/exact/predicates.h"

namespace trivet {
namespace {

// Twice the polygon's area in each coordinate plane [Newell]; about a corner, as offsets cost
// digits.
Vec3 newell_normal(std::span<const Vec3> corners) {
  Vec3 normal = Vec3::Zero();
  for (size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return normal;
}

// Axes by how much of the polygon is seen along them.
std::array<int, 3> axes_by_area(const Vec3& normal) {
  std::array<int, 3> axes{2, 1, 0};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return std::abs(normal[a]) > std::abs(normal[b]); });
  return axes;
}

// Along an axis, so that the polygon runs counter-clockwise.
std::vector<Vec2> projected(std::span<const Vec3> corners, int axis, bool turned) {
  const int u = (axis + (turned ? 2 : 1)) % 3, v = (axis + (turned ? 1 : 2)) % 3;
  std::vector<Vec2> out;
  out.reserve(corners.size());
  for (const Vec3& c : corners) out.emplace_back(c[u], c[v]);
  return out;
}

/// Cuts ears off a polygon that runs counter-clockwise.
class EarCutter {
 public:
  explicit EarCutter(std::vector<Vec2> points) : m_points(std::move(points)) {
    // The polygon is a ring of links, from which corners are taken out.
    const Index n = static_cast<Index>(m_points.size());
    for (Index i = 0; i < n; ++i) {
      m_previous.push_back(i == 0 ? n - 1 : i - 1);
      m_next.push_back(i + 1 == n ? 0 : i + 1);
    }
    for (Index i = 0; i < n; ++i)
      if (turn(i) <= 0) m_blunt.push_back(i);
  }

  /// False: no ear is left before the end.
  bool cut(std::vector<Index3>& triangles) {
    // Each turn of the loop cuts one ear and leaves a polygon with one corner less.
    Index at = 0;
    for (size_t left = m_points.size(); left > 3; --left) {
      at = ear_from(at, left);
      if (at < 0) return false;
      triangles.push_back({m_previous[at], at, m_next[at]});
      at = remove(at);
    }
    // The last three corners are the last triangle, which may be flat but not turned over.
    if (turn(at) < 0) return false;
    triangles.push_back({m_previous[at], at, m_next[at]});
    return true;
  }

 private:
  int turn(Index i) const {
    return orient2d(m_points[m_previous[i]], m_points[i], m_points[m_next[i]]);
  }

  // An ear with area, else a corner on a line; -1: there is neither.
  Index ear_from(Index at, size_t left) const {
    // The search goes round once from where it was; corners on a line are cut only when no true ear
    // is left.
    for (size_t tried = 0; tried < left; ++tried, at = m_next[at])
      if (turn(at) > 0 && is_free(at)) return at;
    for (size_t tried = 0; tried < left; ++tried, at = m_next[at])
      if (turn(at) == 0) return at;
    return -1;
  }

  // Only corners that are not convex can be the first to lie in the way.
  bool is_free(Index ear) const {
    const Vec2 &a = m_points[m_previous[ear]], &b = m_points[ear], &c = m_points[m_next[ear]];
    return std::none_of(m_blunt.begin(), m_blunt.end(), [&](Index i) {
      // A corner at the same place as one of the ear is touched, not crossed.
      const Vec2& p = m_points[i];
      if (p == a || p == b || p == c) return false;
      return orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
    });
  }

  // @return the corner to go on with: not the next one, so that few triangles share a corner.
  Index remove(Index i) {
    const Index before = m_previous[i], after = m_next[i];
    m_next[before] = after;
    m_previous[after] = before;
    // A corner may become convex when its neighbour goes, but never the other way round.
    std::erase_if(m_blunt,
                  [&](Index b) { return b == i || ((b == before || b == after) && turn(b) > 0); });
    return m_next[after];
  }

  std::vector<Vec2> m_points;
  std::vector<Index> m_previous, m_next;
  std::vector<Index> m_blunt;  // of 180 degrees or more
};

void add_fan(size_t num_corners, std::vector<Index3>& triangles) {
  for (Index i = 1; i + 1 < static_cast<Index>(num_corners); ++i)
    triangles.push_back({0, i, i + 1});
}

// Most quads: strictly convex there at least, where the diagonal from the first corner ends.
bool halves_are_positive(const std::vector<Vec2>& p) {
  return orient2d(p[0], p[1], p[2]) > 0 && orient2d(p[0], p[2], p[3]) > 0;
}

bool is_on_a_line(const std::vector<Vec2>& p) {
  for (size_t i = 2; i < p.size(); ++i)
    if (orient2d(p[i - 2], p[i - 1], p[i]) != 0) return false;
  return true;
}

bool cut(std::vector<Vec2> points, std::vector<Index3>& triangles) {
  if (points.size() == 4 && halves_are_positive(points)) {
    add_fan(4, triangles);
    return true;
  }
  const size_t before = triangles.size();
  if (EarCutter(std::move(points)).cut(triangles)) return true;
  triangles.resize(before);
  return false;
}

}  // namespace

bool triangulate(std::span<const Vec3> corners, std::vector<Index3>& triangles) {
  assert(corners.size() >= 3);
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  // The projection with the largest area comes first; others help where a bent polygon crosses
  // itself in it.
  const Vec3 normal = newell_normal(corners);
  bool has_area = false;
  // Each axis is tried until the polygon can be cut without overlap.
  for (const int axis : axes_by_area(normal)) {
    std::vector<Vec2> points = projected(corners, axis, normal[axis] < 0);
    if (is_on_a_line(points)) continue;  // seen edgewise
    has_area = true;
    if (cut(std::move(points), triangles)) return true;
  }
  // A polygon that crosses itself in every projection gets a fan, and the caller is told.
  add_fan(corners.size(), triangles);
  return !has_area;
}

}  // namespace trivet
