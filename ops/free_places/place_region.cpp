#include "ops/free_places/place_region.h"

#include <algorithm>

#include "core/base/cross.h"

namespace trivet {
namespace {

constexpr double kStraight = 1e-12;  // sine by which corners in a line may turn the other way

// Greatest of (vertex - point) . direction, seen from above.
double reach(const Body& body, const Vec2& point, const Vec2& direction) {
  double out = -kInfinity;
  for (Index v = 0; v < static_cast<Index>(body.shape->mesh.vertices.size()); ++v)
    out = std::max(out, direction.dot(body.vertex(v).head<2>() - point));
  return out;
}

}  // namespace

std::vector<Vec2> region_of(const std::vector<Vec2>& corners) {
  // Two corners mean a rectangle.
  if (corners.size() != 2) return corners;
  const Vec2 lower = corners[0].cwiseMin(corners[1]), upper = corners[0].cwiseMax(corners[1]);
  return {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
}

bool is_convex_region(const std::vector<Vec2>& corners) {
  if (corners.size() < 3) return false;
  // Every corner has to lie on the left of every side.
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec2 along = corners[(i + 1) % corners.size()] - corners[i];
    const auto is_left = [&](const Vec2& p) {
      const Vec2 to = p - corners[i];
      return cross(along, to) >= -kStraight * along.norm() * to.norm();
    };
    if (along == Vec2::Zero() || !std::all_of(corners.begin(), corners.end(), is_left))
      return false;
  }
  return true;
}

PlaceRegion::PlaceRegion(const std::vector<Vec2>& corners) {
  if (corners.empty()) return;
  std::swap(m_lower, m_upper);
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Vec2 outwards = Vec2(b.y() - a.y(), a.x() - b.x()).normalized();
    m_sides.push_back({outwards, outwards.dot(a)});
    m_lower = m_lower.cwiseMin(a);
    m_upper = m_upper.cwiseMax(a);
  }
}

bool PlaceRegion::holds(const Vec2& point) const {
  return std::all_of(m_sides.begin(), m_sides.end(),
                     [&](const Side& side) { return side.outwards.dot(point) <= side.bound; });
}

bool PlaceRegion::holds(const Body& body) const {
  if (is_all()) return true;
  for (Index v = 0; v < static_cast<Index>(body.shape->mesh.vertices.size()); ++v)
    if (!holds(Vec2(body.vertex(v).head<2>()))) return false;
  return true;
}

PlaceRegion PlaceRegion::of_point(const Vec2& point, const Body& body) const {
  PlaceRegion out = *this;
  // Each side moves inwards by how far the body reaches beyond the point.
  if (is_all()) return out;
  for (Side& side : out.m_sides) side.bound -= reach(body, point, side.outwards);
  for (int k = 0; k < 2; ++k) {
    out.m_lower[k] += reach(body, point, -Vec2::Unit(k));
    out.m_upper[k] -= reach(body, point, Vec2::Unit(k));
  }
  return out;
}

}  // namespace trivet
