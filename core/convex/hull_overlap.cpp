#include "core/convex/hull_overlap.h"

#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivet {
namespace {

constexpr size_t kFewFaces = 16;  // of a part: two have 24 edges each at most

/// Part relative to a centre common to both, scaled to a size of about 1, so that libccd's absolute
/// tolerances become relative ones.
struct Scaled {
  const PlacedPart& part;
  Vec3 centre;
  double scale;
};

void farthest(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Scaled& scaled = *static_cast<const Scaled*>(object);
  const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3* best = nullptr;
  double largest = -kInfinity;
  // The support function of a hull is its farthest vertex; the first of equals wins.
  for (const Vec3& v : scaled.part.vertices)
    if (const double along = d.dot(v - scaled.centre); along > largest) largest = along, best = &v;
  const Vec3 p = (*best - scaled.centre) * scaled.scale;
  for (int i = 0; i < 3; ++i) out->v[i] = p[i];
}

/// Directions in which few-faced parts may leave each other shortest: normals of faces, and of
/// pairs of edges. [Gottschalk 1996: one of them separates two polyhedra that are apart.]
class WaysOut {
 public:
  WaysOut(const PlacedPart& a, const PlacedPart& b) : m_a(a), m_b(b) {}

  /// The shorter of both ways out along a direction of any length, or `depth` if that is less.
  double shortest(const Vec3& direction, double depth) const {
    const double length = direction.norm();
    if (!(length > 0) || !std::isfinite(length)) return depth;
    const Vec3 along = direction / length;
    const auto [low_a, high_a] = extent(m_a, along);
    const auto [low_b, high_b] = extent(m_b, along);
    return std::max(0.0, std::min({depth, high_a - low_b, high_b - low_a}));
  }

  double shortest_of_all(double depth) const {
    const std::vector<Vec3> edges_a = edges(m_a), edges_b = edges(m_b);
    for (const PlacedPart* part : {&m_a, &m_b})
      for (const Index3& t : part->triangles) depth = shortest(normal(*part, t), depth);
    for (const Vec3& of_a : edges_a)
      for (const Vec3& of_b : edges_b) depth = shortest(across(of_a, of_b), depth);
    return depth;
  }

 private:
  static constexpr double kParallel = 1e-6;  // sine: the cross product of such edges is rounding

  static std::pair<double, double> extent(const PlacedPart& part, const Vec3& along) {
    double low = kInfinity, high = -kInfinity;
    for (const Vec3& v : part.vertices) {
      low = std::min(low, along.dot(v));
      high = std::max(high, along.dot(v));
    }
    return {low, high};
  }

  static Vec3 normal(const PlacedPart& part, const Index3& t) {
    const Vec3& a = part.vertices[t[0]];
    return across(part.vertices[t[1]] - a, part.vertices[t[2]] - a);
  }

  static Vec3 across(const Vec3& a, const Vec3& b) {
    const Vec3 out = a.cross(b);
    return out.norm() > kParallel * a.norm() * b.norm() ? out : Vec3::Zero();
  }

  static std::vector<Vec3> edges(const PlacedPart& part) {
    std::vector<Vec3> out;
    for (const Index3& t : part.triangles)
      for (int k = 0; k < 3; ++k)
        if (const Index from = t[k], to = t[(k + 1) % 3]; from < to)
          out.push_back(part.vertices[to] - part.vertices[from]);
    return out;
  }

  const PlacedPart &m_a, &m_b;
};

}  // namespace

PlacedPart::PlacedPart(const ConvexPart& part, const Affine& world_from_part)
    : triangles(part.triangles) {
  for (const Vec3& v : part.vertices) {
    vertices.push_back(world_from_part.apply(v));
    box.extend(vertices.back());
  }
}

double penetration_depth(const PlacedPart& a, const PlacedPart& b) {
  // Most pairs of parts are told apart by their boxes.
  if (a.vertices.empty() || b.vertices.empty() || !overlaps(a.box, b.box)) return 0;
  Aabb both = a.box;
  both.extend(b.box);
  const double scale = 1 / both.diagonal();
  const Scaled of_a{a, both.centre(), scale}, of_b{b, both.centre(), scale};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = farthest;
  ccd.max_iterations = 1000;
  ccd.epa_tolerance = 1e-6;
  ccd_real_t depth = 0;
  ccd_vec3_t direction, position;
  if (ccdGJKPenetration(&of_a, &of_b, &ccd, &depth, &direction, &position) != 0) return 0;
  // The expanding polytope gives a lower bound, and stops early where it is degenerate.
  const Vec3 along = Vec3(direction.v[0], direction.v[1], direction.v[2]).normalized();
  // The hulls' overlap along the direction found is exact; of both ways out the shorter counts.
  const WaysOut ways(a, b);
  const double found =
      along.allFinite() && along.norm() > 0.5 ? ways.shortest(along, kInfinity) : depth / scale;
  // The polytope of slivers is so narrow that the direction may be far from the best one.
  const bool few = std::max(a.triangles.size(), b.triangles.size()) <= kFewFaces;
  return few ? ways.shortest_of_all(found) : found;
}

}  // namespace trivet
