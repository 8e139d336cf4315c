#include "core/convex/surface_probe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace trivet {
namespace {

constexpr int kSteps = 12;                         // of a part's size
const Vec3 kRay(0.6180339887, 0.3141592653, 0.7);  // meets few edges of what people model

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (p - a - t * along).squaredNorm();
}

double squared_distance_to_box(const Vec3& p, const BvhNode& node) {
  const Aabb box = node.box();
  return (box.lower - p).cwiseMax(p - box.upper).cwiseMax(0).squaredNorm();
}

bool ray_meets_box(const Vec3& from, const BvhNode& node) {
  double enter = 0, leave = kInfinity;
  for (int k = 0; k < 3; ++k) {
    enter = std::max(enter, (node.lower[k] - from[k]) / kRay[k]);
    leave = std::min(leave, (node.upper[k] - from[k]) / kRay[k]);
  }
  return enter <= leave;
}

/// 1 where the ray leaves through the front of the triangle, -1 through its back, 0: it misses.
int crossing(const Vec3& from, const Triangle& t) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], across = kRay.cross(e2);
  const double det = e1.dot(across);
  if (det == 0) return 0;
  const Vec3 offset = from - t[0], other = offset.cross(e1);
  const double u = offset.dot(across) / det, v = kRay.dot(other) / det;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && e2.dot(other) / det > 0)) return 0;
  return det < 0 ? 1 : -1;
}

double longest_edge(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

/// Calls for the middles of equal small triangles of a face.
template <class Use>
void for_each_sample(const Triangle& face, double size, Use use) {
  const int n =
      std::clamp(static_cast<int>(std::ceil(kSteps * longest_edge(face) / size)), 1, kSteps);
  const auto at = [&](double u, double v) {
    return Vec3(face[0] + u / n * (face[1] - face[0]) + v / n * (face[2] - face[0]));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      use(at(i + 1.0 / 3, j + 1.0 / 3));
      if (i + j < n - 1) use(at(i + 2.0 / 3, j + 2.0 / 3));
    }
}

}  // namespace

double squared_distance(const Vec3& point, const Triangle& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  double least = kInfinity;
  bool above = normal.squaredNorm() > 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = triangle[k], &b = triangle[(k + 1) % 3];
    above = above && normal.cross(b - a).dot(point - a) >= 0;
    least = std::min(least, squared_distance_to_segment(point, a, b));
  }
  if (!above) return least;
  const double height = normal.dot(point - triangle[0]);
  return std::min(least, height * height / normal.squaredNorm());
}

SurfaceProbe::SurfaceProbe(const Mesh& mesh, const Adjacency& adjacency)
    : m_mesh(mesh), m_bvh(build_bvh(mesh)) {
  m_is_closed.reserve(mesh.triangles.size());
  for (const Index component : adjacency.face_component)
    m_is_closed.push_back(adjacency.components[static_cast<size_t>(component)].balanced);
}

StandsOut SurfaceProbe::farthest(const ConvexPart& part, const StandsOut& known) const {
  StandsOut out = known;
  if (m_bvh.nodes.empty()) return out;
  Aabb box;
  for (const Vec3& v : part.vertices) box.extend(v);
  for (const Index3& t : part.triangles) {
    const Triangle face{part.vertices[t[0]], part.vertices[t[1]], part.vertices[t[2]]};
    for_each_sample(face, box.diagonal(), [&](const Vec3& p) { out = farther(p, out); });
  }
  return out;
}

StandsOut SurfaceProbe::farther(const Vec3& point, const StandsOut& known) const {
  const double squared = squared_distance(point, known.distance * known.distance);
  if (squared <= known.distance * known.distance || is_inside(point)) return known;
  return {std::sqrt(squared), point};
}

// The least one, or one that is not more than `enough`.
double SurfaceProbe::squared_distance(const Vec3& point, double enough) const {
  double least = kInfinity;
  std::vector<Index> open{0};
  while (!open.empty() && least > enough) {
    const Index i = open.back();
    open.pop_back();
    const BvhNode& node = m_bvh.nodes[static_cast<size_t>(i)];
    if (squared_distance_to_box(point, node) >= least) continue;
    if (node.is_leaf()) {
      for (Index k = 0; k < node.num_faces; ++k) {
        const Index face =
            m_bvh.faces[static_cast<size_t>(node.second_child) + static_cast<size_t>(k)];
        least = std::min(least, trivet::squared_distance(point, m_mesh.triangle(face)));
      }
      continue;
    }
    std::array<Index, 2> children{i + 1, node.second_child};
    const auto far_off = [&](Index child) {
      return squared_distance_to_box(point, m_bvh.nodes[static_cast<size_t>(child)]);
    };
    // The nearer child is opened first.
    if (far_off(children[0]) < far_off(children[1])) std::swap(children[0], children[1]);
    open.insert(open.end(), children.begin(), children.end());
  }
  return least;
}

// By the winding number of closed components.
bool SurfaceProbe::is_inside(const Vec3& point) const {
  int winding = 0;
  std::vector<Index> open{0};
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    const BvhNode& node = m_bvh.nodes[static_cast<size_t>(i)];
    if (!ray_meets_box(point, node)) continue;
    if (!node.is_leaf()) {
      open.push_back(node.second_child);
      open.push_back(i + 1);
      continue;
    }
    for (Index k = 0; k < node.num_faces; ++k) {
      const Index face =
          m_bvh.faces[static_cast<size_t>(node.second_child) + static_cast<size_t>(k)];
      if (m_is_closed[static_cast<size_t>(face)]) winding += crossing(point, m_mesh.triangle(face));
    }
  }
  return winding != 0;
}

}  // namespace trivet
