#include "core/io/foreign/primitives.h"

#include <cmath>

#include "core/io/foreign/scene.h"
#include "core/mesh/hull.h"

namespace trivet {
namespace {

// Sides of a circle: multiples of 4, so that its four outermost points are exact.
constexpr int kRoundSides = 408, kCapSides = 128;

/// Points of a unit circle from the angle 0 on, quarters alike.
std::vector<Vec2> circle(int sides) {
  std::vector<Vec2> out;
  for (int k = 0; k < sides; ++k) {
    // Angles go by rotations without libm: the same points on every machine.
    const Rotation r = turn_about(Vec3::UnitZ(), 360.0 * k / sides);
    out.emplace_back(r.w * r.w - r.z * r.z, 2 * r.w * r.z);
  }
  return out;
}

/// A body of revolution about z, from rings or poles of the radius and height of `profile`, the
/// lowest first.
class Revolution {
 public:
  explicit Revolution(int sides) : m_circle(circle(sides)) {}

  void add(double radius, double z) {
    const auto first = static_cast<Index>(m_mesh.vertices.size());
    const bool pole = radius == 0;
    if (pole)
      m_mesh.vertices.emplace_back(0, 0, z);
    else
      for (const Vec2& p : m_circle)
        m_mesh.vertices.emplace_back(radius * p.x(), radius * p.y(), z);
    if (m_last >= 0) connect(m_last, m_last_is_pole, first, pole);
    m_last = first;
    m_last_is_pole = pole;
  }
  Mesh take() { return std::move(m_mesh); }

 private:
  void connect(Index low, bool low_is_pole, Index high, bool high_is_pole) {
    // A ring meets the next one by two triangles a side, a pole by one.
    const auto n = static_cast<Index>(m_circle.size());
    for (Index k = 0; k < n; ++k) {
      const Index next = (k + 1) % n;
      if (!low_is_pole)
        m_mesh.triangles.push_back({low + k, low + next, high + (high_is_pole ? 0 : k)});
      if (!high_is_pole)
        m_mesh.triangles.push_back({low + (low_is_pole ? 0 : next), high + next, high + k});
    }
  }

  std::vector<Vec2> m_circle;
  Mesh m_mesh;
  Index m_last = -1;
  bool m_last_is_pole = false;
};

// From the south pole up to the equator: radius and height of a unit sphere.
std::vector<Vec2> southern_profile(int sides) {
  std::vector<Vec2> out;
  const std::vector<Vec2> points = circle(sides);
  for (int k = 0; k <= sides / 4; ++k) {
    const Vec2& p = points[static_cast<size_t>(k)];
    out.emplace_back(k == 0 ? 0 : p.y(), -p.x());
  }
  // The equator is exact, whatever the last angle rounds to.
  out.back() = Vec2(1, 0);
  return out;
}

// The northern half mirrors the southern: heights are the same bits.
Mesh ellipsoid_of_sides(const Vec3& radii, int sides) {
  Revolution body(sides);
  const std::vector<Vec2> south = southern_profile(sides);
  for (const Vec2& p : south) body.add(p.x(), p.y());
  for (size_t k = south.size() - 1; k-- > 0;) body.add(south[k].x(), -south[k].y());
  Mesh out = body.take();
  for (Vec3& v : out.vertices) v = v.cwiseProduct(radii);
  return out;
}

}  // namespace

Mesh box_mesh(const Vec3& half) {
  Mesh out;
  for (int i = 0; i < 8; ++i)
    out.vertices.emplace_back(i & 4 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                              i & 1 ? half.z() : -half.z());
  out.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                   {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return out;
}

Mesh ellipsoid_mesh(const Vec3& radii) { return ellipsoid_of_sides(radii, kCapSides); }

Mesh ball_mesh(double radius, int sides) {
  return ellipsoid_of_sides(Vec3::Constant(radius), sides);
}

Mesh cylinder_mesh(double radius, double half) {
  Revolution body(kRoundSides);
  body.add(0, -half), body.add(radius, -half), body.add(radius, half), body.add(0, half);
  return body.take();
}

Mesh capsule_mesh(double radius, double half) {
  Revolution body(kCapSides);
  const std::vector<Vec2> south = southern_profile(kCapSides);
  for (const Vec2& p : south) body.add(radius * p.x(), radius * p.y() - half);
  for (size_t k = south.size(); k-- > 0;)
    body.add(radius * south[k].x(), half - radius * south[k].y());
  return body.take();
}

Mesh hull_mesh(std::span<const Vec3> points) {
  const ConvexHull hull = convex_hull(points);
  Mesh out;
  if (hull.vertices.empty()) return out;
  // Only corners of the hull are kept, in their order.
  std::vector<Index> new_id(points.size(), -1);
  Vec3 middle = Vec3::Zero();
  for (const Index v : hull.vertices) {
    new_id[v] = static_cast<Index>(out.vertices.size());
    out.vertices.push_back(points[v]);
    middle += points[v] / static_cast<double>(hull.vertices.size());
  }
  for (const Index3& t : hull.triangles) {
    Index3 face{new_id[t[0]], new_id[t[1]], new_id[t[2]]};
    // Triangles are turned to look away from the middle.
    const Triangle p{points[t[0]], points[t[1]], points[t[2]]};
    if ((p[1] - p[0]).cross(p[2] - p[0]).dot(p[0] - middle) < 0) std::swap(face[1], face[2]);
    out.triangles.push_back(face);
  }
  return out;
}

void append(const Mesh& mesh, const Pose& pose, Mesh& out) {
  append(mesh, world_from_object(pose, UpAxis::Z, 1), out);
}

void append(const Mesh& mesh, const Affine& place, Mesh& out) {
  const auto first = static_cast<Index>(out.vertices.size());
  for (const Vec3& v : mesh.vertices) out.vertices.push_back(place.apply(v));
  for (const Index3& t : mesh.triangles)
    out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace trivet
