// Few contacts with nearly the same span of forces as many.
#include <algorithm>

#include "core/contact/contact_points.h"
#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kSameNormal = 0.999;  // cosine

// The farthest from what is chosen already, again and again.
template <class Point>
std::vector<Point> farthest(const std::vector<Point>& points, size_t limit) {
  std::vector<double> distance(points.size(), kInfinity);
  std::vector<char> chosen(points.size(), 0);
  size_t next = 0;
  for (size_t n = 0; n < std::min(limit, points.size()); ++n) {
    chosen[next] = 1;
    size_t best = next;
    // Distances to the chosen points are updated by the newest alone.
    for (size_t i = 0; i < points.size(); ++i) {
      distance[i] = std::min(distance[i], (points[i].point - points[next].point).squaredNorm());
      if (!chosen[i] && (chosen[best] || distance[i] > distance[best])) best = i;
    }
    next = best;
  }
  std::vector<Point> out;
  for (size_t i = 0; i < points.size(); ++i)
    if (chosen[i]) out.push_back(points[i]);
  return out;
}

// Among points with one normal, keeps those whose feet on the plane are the hull's corners.
template <class Point>
std::vector<Point> hull_points(const std::vector<Point>& points) {
  if (points.size() < 4) return points;
  // The plane is that of the common normal.
  const auto [u, v] = tangents(points.front().normal);
  const auto flat = [&, u = u, v = v](const Point& p) {
    return Vec2(u.dot(p.point), v.dot(p.point));
  };
  std::vector<Vec2> all;
  all.reserve(points.size());
  for (const Point& p : points) all.push_back(flat(p));
  // Forces of points inside the hull are sums of those at its corners.
  std::vector<Vec2> hull = convex_hull(all);
  std::vector<Point> out;
  for (const Point& p : points) {
    const auto at = std::find(hull.begin(), hull.end(), flat(p));
    if (at == hull.end()) continue;
    out.push_back(p);
    hull.erase(at);  // each corner once
  }
  return out;
}

bool same_friction(const ContactPoint&, const ContactPoint&) { return true; }
bool same_friction(const FrictionContact& a, const FrictionContact& b) {
  return a.friction == b.friction;
}

template <class Point>
std::vector<Point> reduced_points(const std::vector<Point>& contacts, size_t limit) {
  if (contacts.size() <= limit) return contacts;
  // Contacts of nearly one normal and equal friction form a plane: corners of its hull give the
  // same forces as all.
  std::vector<std::vector<Point>> groups;
  for (const Point& c : contacts) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.front().normal.dot(c.normal) > kSameNormal && same_friction(group.front(), c);
    });
    if (same == groups.end())
      groups.push_back({c});
    else
      same->push_back(c);
  }
  std::vector<Point> out;
  for (const auto& group : groups)
    for (const Point& c : hull_points(group)) out.push_back(c);
  // Corners alone may still be too many: the farthest from each other represent them.
  return out.size() <= limit ? out : farthest(out, limit);
}

}  // namespace

std::vector<ContactPoint> reduced(const std::vector<ContactPoint>& contacts, size_t limit) {
  return reduced_points(contacts, limit);
}

std::vector<FrictionContact> reduced(const std::vector<FrictionContact>& contacts, size_t limit) {
  return reduced_points(contacts, limit);
}

}  // namespace trivet
