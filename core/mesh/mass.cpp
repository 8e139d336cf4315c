#include "core/mesh/mass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/hull.h"

namespace trivet {
namespace {

/// A volume below this fraction of area x box diagonal is rounding error.
constexpr double kLeastVolume = 1e-9;

/// Integrals of 1, x, |x|^2 and x x^T over a body, where x is relative to an origin.
struct Moments {
  double measure = 0;
  Vec3 first = Vec3::Zero();
  double second = 0;
  Mat3 products = Mat3::Zero();

  /// Adds the simplex with these corners; if it is a tetrahedron, the origin is its apex.
  void add(double size, const Triangle& corners, int num_corners) {
    const Vec3 sum = corners[0] + corners[1] + corners[2];
    const double squares =
        corners[0].squaredNorm() + corners[1].squaredNorm() + corners[2].squaredNorm();
    measure += size;
    first += size / num_corners * sum;
    const double weight = size / (num_corners * (num_corners + 1));
    second += weight * (squares + sum.squaredNorm());
    products += weight * sum * sum.transpose();
    for (const Vec3& c : corners) products += weight * c * c.transpose();
  }

  Vec3 centre() const { return first / measure; }
  /// Mean squared distance from the centre.
  double spread() const { return second / measure - centre().squaredNorm(); }
  Mat3 covariance() const { return products / measure - centre() * centre().transpose(); }
};

struct MeshMoments {
  Moments solid;                          // signed tetrahedra
  Moments surface;                        // triangles
  std::vector<double> component_volumes;  // signed
};

Triangle relative_to(const Vec3& origin, const Triangle& t) {
  return {t[0] - origin, t[1] - origin, t[2] - origin};
}

double signed_volume(const Triangle& t) { return t[0].cross(t[1]).dot(t[2]) / 6; }

MeshMoments integrate(const Mesh& mesh, const Adjacency& adjacency, const Vec3& origin) {
  MeshMoments out;
  out.component_volumes.resize(adjacency.components.size());
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = relative_to(origin, mesh.triangle(f));
    const double volume = signed_volume(t);
    out.solid.add(volume, t, 4);
    out.surface.add((t[1] - t[0]).cross(t[2] - t[0]).norm() / 2, t, 3);
    out.component_volumes[adjacency.face_component[f]] += volume;
  }
  return out;
}

/// True if the signed tetrahedra form a body: cavities may be negative in a positive total.
bool is_solid(const MeshMoments& moments, const Adjacency& adjacency, const Aabb& box) {
  const double volume = moments.solid.measure;
  const double least = kLeastVolume * moments.surface.measure * box.diagonal();
  if (!(std::abs(volume) > least)) return false;
  if (!std::all_of(adjacency.components.begin(), adjacency.components.end(),
                   [](const Component& c) { return c.balanced; }))
    return false;
  const bool some_positive =
      std::any_of(moments.component_volumes.begin(), moments.component_volumes.end(),
                  [&](double v) { return v > least; });
  if (volume < 0 && some_positive) return false;
  return (moments.solid.centre().cwiseAbs().array() <= box.half_extent().array()).all();
}

/// Tetrahedra from a point inside the hull to its triangles: all positive, whatever their winding.
Moments hull_moments(const Mesh& mesh, const ConvexHull& hull, const Vec3& inside) {
  Moments out;
  for (const Index3& h : hull.triangles) {
    const Triangle t =
        relative_to(inside, {mesh.vertices[h[0]], mesh.vertices[h[1]], mesh.vertices[h[2]]});
    out.add(std::abs(signed_volume(t)), t, 4);
  }
  return out;
}

Moments point_moments(const std::vector<Vec3>& points, const Vec3& origin) {
  Moments out;
  for (const Vec3& p : points) {
    const Vec3 x = p - origin;
    out.measure += 1;
    out.first += x;
    out.second += x.squaredNorm();
    out.products += x * x.transpose();
  }
  return out;
}

Vec3 mean_of(const Mesh& mesh, const std::vector<Index>& vertices) {
  const Vec3& origin = mesh.vertices[vertices[0]];
  Vec3 sum = Vec3::Zero();
  for (const Index v : vertices) sum += mesh.vertices[v] - origin;
  return origin + sum / static_cast<double>(vertices.size());
}

void set_centre(MassProperties& out, MassRule rule, const Moments& moments, const Vec3& origin) {
  out.rule = rule;
  out.centre = origin + moments.centre();
  out.radius_squared = moments.spread();
  out.covariance = moments.covariance();
}

/// Fallback for meshes without area.
void set_hull(MassProperties& out, const Mesh& mesh, const Vec3& box_centre) {
  const ConvexHull hull = convex_hull(mesh.vertices);
  if (!hull.vertices.empty()) {
    const Vec3 inside = mean_of(mesh, hull.vertices);
    const Moments moments = hull_moments(mesh, hull, inside);
    if (moments.measure > 0) {
      out.volume = moments.measure;
      return set_centre(out, MassRule::Hull, moments, inside);
    }
  }
  set_centre(out, MassRule::Hull, point_moments(mesh.vertices, box_centre), box_centre);
}

}  // namespace

const char* to_string(MassRule rule) {
  switch (rule) {
    case MassRule::Volume:
      return "volume";
    case MassRule::Surface:
      return "surface";
    case MassRule::Hull:
      return "hull";
  }
  return "";
}

MassProperties mass_properties(const Mesh& mesh, const Adjacency& adjacency) {
  MassProperties out;
  if (mesh.vertices.empty()) {
    out.rule = MassRule::Hull;
    return out;
  }
  const Aabb box = mesh.box();
  const Vec3 origin = box.centre();
  const MeshMoments moments = integrate(mesh, adjacency, origin);
  out.area = moments.surface.measure;
  if (is_solid(moments, adjacency, box)) {
    out.volume = std::abs(moments.solid.measure);
    set_centre(out, MassRule::Volume, moments.solid, origin);
  } else if (out.area > 0) {
    set_centre(out, MassRule::Surface, moments.surface, origin);
  } else {
    set_hull(out, mesh, origin);
  }
  if (!(out.radius_squared > 0) || !std::isfinite(out.radius_squared)) {
    const Vec3 size = 2 * box.half_extent();
    out.radius_squared = box.diagonal() * box.diagonal() / 12;  // that of a box full of mass
    out.covariance = (size.cwiseProduct(size) / 12).asDiagonal();
  }
  return out;
}

Mat3 inertia_per_mass(const Mat3& covariance) {
  return covariance.trace() * Mat3::Identity() - covariance;
}

std::vector<Index> convex_hull_vertices(const Mesh& mesh) {
  std::vector<Index> vertices = convex_hull(mesh.vertices).vertices;
  if (vertices.empty()) {
    vertices.resize(mesh.vertices.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  return vertices;
}

}  // namespace trivet
