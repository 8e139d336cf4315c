#include "ops/arrange/convex_region.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/angles.h"

namespace trivet {
namespace {

constexpr double kWider = 1 + 1e-9;  // far more than rounding

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
  return a + t * along;
}

bool inside(const std::vector<Vec2>& polygon, const Vec2& p) {
  // The polygon runs counter-clockwise, so that its inside is to the left.
  if (polygon.size() < 3) return false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    if (cross(Vec2(polygon[(i + 1) % polygon.size()] - a), Vec2(p - a)) < 0) return false;
  }
  return true;
}

// From a point of one to the edges of the other that it is beyond; infinity: it is inside.
double squared_distance_to_outline(const Vec2& p, const std::vector<Vec2>& polygon) {
  double out = kInfinity;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    // Only edges that the point is beyond can be nearest.
    if (cross(b - a, p - a) > 0) continue;
    out = std::min(out, (nearest_on_segment(p, a, b) - p).squaredNorm());
  }
  return out;
}

struct Box {
  Vec2 lower = Vec2::Constant(kInfinity), upper = Vec2::Constant(-kInfinity);
  explicit Box(const std::vector<Vec2>& points) {
    for (const Vec2& p : points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  }
  double squared_distance(const Vec2& p) const {
    return (p - p.cwiseMax(lower).cwiseMin(upper)).squaredNorm();
  }
};

// The smaller of `least` and the squared distances of these points from a polygon, of which those
// that its box shows to be farther are left out.
double least_squared_distance(const std::vector<Vec2>& points, const std::vector<Vec2>& polygon,
                              double least) {
  const Box box(polygon);
  for (const Vec2& p : points)
    if (box.squared_distance(p) <= kWider * least)
      least = std::min(least, squared_distance_to_outline(p, polygon));
  return least;
}

// A point of the other one that is nearest to the middle of this.
const Vec2& nearest_to_middle(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& p : a) middle += p / double(a.size());
  return *std::min_element(b.begin(), b.end(), [&](const Vec2& p, const Vec2& q) {
    return (p - middle).squaredNorm() < (q - middle).squaredNorm();
  });
}

// True if an edge of `a` has all of `b` beyond it.
bool separated_by_edge(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  for (size_t i = 0; i < a.size(); ++i) {
    // Polygons apart have a separating edge of either, as edges are all directions needed in the
    // plane.
    const Vec2 out = -quarter_turned(a[(i + 1) % a.size()] - a[i]);
    if (-extent(b, -out) >= out.dot(a[i])) return true;
  }
  return false;
}

}  // namespace

ConvexRegion::ConvexRegion(const Vec2& lower, const Vec2& upper) {
  if ((lower.array() > upper.array()).any()) return;
  m_corners = {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
}

void ConvexRegion::clip(const HalfPlane& half_plane) {
  std::vector<Vec2> out;
  out.reserve(m_corners.size() + 1);
  // Corners inside stay; edges that cross the line add the point where they do.
  for (size_t i = 0; i < m_corners.size(); ++i) {
    const Vec2 &a = m_corners[i], &b = m_corners[(i + 1) % m_corners.size()];
    const double over_a = half_plane.normal.dot(a) - half_plane.bound;
    const double over_b = half_plane.normal.dot(b) - half_plane.bound;
    if (over_a <= 0) out.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      out.push_back(a + over_a / (over_a - over_b) * (b - a));
  }
  m_corners = std::move(out);
}

Vec2 ConvexRegion::lower() const {
  Vec2 out = Vec2::Constant(kInfinity);
  for (const Vec2& p : m_corners) out = out.cwiseMin(p);
  return out;
}

Vec2 ConvexRegion::upper() const {
  Vec2 out = Vec2::Constant(-kInfinity);
  for (const Vec2& p : m_corners) out = out.cwiseMax(p);
  return out;
}

Vec2 ConvexRegion::nearest(const Vec2& p) const {
  if (inside(m_corners, p)) return p;
  Vec2 out = m_corners.front();
  for (size_t i = 0; i < m_corners.size(); ++i) {
    const Vec2 q = nearest_on_segment(p, m_corners[i], m_corners[(i + 1) % m_corners.size()]);
    if ((q - p).squaredNorm() < (out - p).squaredNorm()) out = q;
  }
  return out;
}

double extent(const std::vector<Vec2>& points, const Vec2& direction) {
  double out = -kInfinity;
  for (const Vec2& p : points) out = std::max(out, direction.dot(p));
  return out;
}

double distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double enough) {
  // A near point may show at once that the distance is small enough.
  if (enough > 0 && !a.empty() && !b.empty()) {
    const double near = std::sqrt(squared_distance_to_outline(nearest_to_middle(a, b), a));
    if (near <= enough && near < kInfinity) return near;
  }
  // Outlines that no edge separates overlap; single points and segments have no inside.
  if (!separated_by_edge(a, b) && !separated_by_edge(b, a) && a.size() > 2 && b.size() > 2)
    return 0;
  return std::sqrt(least_squared_distance(b, a, least_squared_distance(a, b, kInfinity)));
}

}  // namespace trivet
