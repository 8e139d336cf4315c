#include "core/io/foreign/primitives.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "core/io/foreign/scene.h"
#include "core/mesh/hull.h"

namespace trivet {
namespace {

// A multiple of 4, so that the four outermost points of a circle are exact.
constexpr int kRoundSides = 408;

/// Point of a unit circle. Angles go by rotations without libm: the same on every machine.
Vec2 at_angle(double degrees) {
  const Rotation r = turn_about(Vec3::UnitZ(), degrees);
  return {r.w * r.w - r.z * r.z, 2 * r.w * r.z};
}

/// Points of a unit circle from the angle 0 on, `per_quarter` in each quarter, all quarters alike.
std::vector<Vec2> circle(int per_quarter) {
  std::vector<Vec2> out;
  for (int k = 0; k < per_quarter; ++k) out.push_back(at_angle(90.0 * k / per_quarter));
  for (size_t k = 0; k < 3 * static_cast<size_t>(per_quarter); ++k)
    out.emplace_back(-out[k].y(), out[k].x());
  return out;
}

/// The southern half of a unit sphere: a pole, then rings of 4, 8, 12, ... points up to the
/// equator. That takes half as many triangles as rings that are all alike.
class Hemisphere {
 public:
  explicit Hemisphere(int num_rings) {
    m_mesh.vertices.push_back(-Vec3::UnitZ());
    Index below = 0;
    for (int k = 1; k <= num_rings; ++k) {
      const auto ring = static_cast<Index>(m_mesh.vertices.size());
      // The equator is exact, whatever the last angle rounds to.
      const Vec2 profile = k == num_rings ? Vec2(0, 1) : at_angle(90.0 * k / num_rings);
      for (const Vec2& p : circle(k))
        m_mesh.vertices.emplace_back(profile.y() * p.x(), profile.y() * p.y(), -profile.x());
      connect(below, ring, k);
      below = ring;
    }
    m_equator = below;
  }
  const Mesh& mesh() const { return m_mesh; }
  /// First vertex of the ring at height 0.
  Index equator() const { return m_equator; }

 private:
  // A ring of `k` sides a quarter with the one below it, which has one fewer.
  void connect(Index below, Index ring, Index k) {
    for (Index quarter = 0; quarter < 4; ++quarter)
      for (Index j = 0; j < k; ++j) {
        const auto low = [&](Index i) {
          return k == 1 ? below : below + (quarter * (k - 1) + i) % (4 * (k - 1));
        };
        const auto high = [&](Index i) { return ring + (quarter * k + i) % (4 * k); };
        m_mesh.triangles.push_back({low(j), high(j + 1), high(j)});
        if (j + 1 < k) m_mesh.triangles.push_back({low(j), low(j + 1), high(j + 1)});
      }
  }

  Mesh m_mesh;
  Index m_equator = 0;
};

// Between two rings of as many points, the lower one first.
void add_band(Index low, Index high, Index num_points, Mesh& mesh) {
  for (Index k = 0; k < num_points; ++k) {
    const Index next = (k + 1) % num_points;
    mesh.triangles.push_back({low + k, low + next, high + k});
    mesh.triangles.push_back({low + next, high + next, high + k});
  }
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

Mesh cylinder_mesh(double radius, double half) {
  const std::vector<Vec2> points = circle(kRoundSides / 4);
  const auto n = static_cast<Index>(points.size());
  Mesh out;
  for (const double z : {-half, half})
    for (const Vec2& p : points) out.vertices.emplace_back(radius * p.x(), radius * p.y(), z);
  add_band(0, n, n, out);
  out.vertices.emplace_back(0, 0, -half), out.vertices.emplace_back(0, 0, half);
  for (Index k = 0; k < n; ++k) {
    const Index next = (k + 1) % n;
    out.triangles.push_back({2 * n, next, k});
    out.triangles.push_back({2 * n + 1, n + k, n + next});
  }
  return out;
}

Mesh round_mesh(const RoundShape& shape, int sides) {
  const Hemisphere south(sides / 4);
  Mesh out = south.mesh();
  const auto num_southern = static_cast<Index>(out.vertices.size());
  // The northern half mirrors the southern: heights are the same bits. It begins with its pole, and
  // has an equator of its own in a capsule.
  const Index num_shared = shape.half > 0 ? 0 : num_southern - south.equator();
  const auto mirrored = [&](Index v) {
    return v >= num_southern - num_shared ? v : num_southern + v;
  };
  for (Index v = 0; v < num_southern - num_shared; ++v)
    out.vertices.push_back(out.vertices[static_cast<size_t>(v)].cwiseProduct(Vec3(1, 1, -1)));
  for (const Index3& t : south.mesh().triangles)
    out.triangles.push_back({mirrored(t[0]), mirrored(t[2]), mirrored(t[1])});
  if (num_shared == 0)
    add_band(south.equator(), mirrored(south.equator()), num_southern - south.equator(), out);
  for (Index v = 0; v < static_cast<Index>(out.vertices.size()); ++v) {
    Vec3& p = out.vertices[static_cast<size_t>(v)];
    const Vec3 cap(0, 0, v < num_southern ? -shape.half : shape.half);
    p = shape.linear * (p.cwiseProduct(shape.radii) + cap);
  }
  if (shape.linear.determinant() < 0)
    for (Index3& t : out.triangles) std::swap(t[1], t[2]);
  return out;
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
