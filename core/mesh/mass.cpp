#include "core/mesh/mass.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mesh/hull.h"
#include "core/mesh/moments.h"
#include "core/mesh/solid_faces.h"

namespace trivet {
namespace {

struct MeshMoments {
  Moments solid;           // signed tetrahedra of closed parts, each with its inside
  Moments surface;         // triangles
  double closed_area = 0;  // of the parts that are solids
};

double solid_sign(const SolidFaces& solid, const Adjacency& adjacency, Index face) {
  return solid.weight(face) * adjacency.components[adjacency.face_component[face]].winding;
}

MeshMoments integrate(const Mesh& mesh, const Adjacency& adjacency, const SolidFaces& solid,
                      const Vec3& origin) {
  MeshMoments out;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    // Coordinates about the box's centre keep digits where the model lies far from its origin.
    const Triangle t = relative_to(origin, mesh.triangle(f));
    const double area = area_of(t);
    // The surface counts for all parts: it decides the mass where too little is closed.
    out.surface.add(area, t, 3);
    if (!solid.closed[adjacency.face_component[f]]) continue;
    out.closed_area += area;
    // A tetrahedron from the origin to each face: those outside the body cancel.
    out.solid.add(solid_sign(solid, adjacency, f) * signed_volume(t), t, 4);
  }
  return out;
}

/// True if the signed tetrahedra form a body.
bool is_solid(const MeshMoments& moments, const Aabb& box) {
  constexpr double kLeast = 1e-9;  // of area x box diagonal; below, a volume is rounding error
  if (!(moments.solid.measure > kLeast * moments.surface.measure * box.diagonal())) return false;
  // A centre outside the box is no body's: the winding was wrong somewhere.
  return (moments.solid.centre().cwiseAbs().array() <= box.half_extent().array()).all();
}

// Closed parts outweigh open ones from half of the area on: a label does not make a box a shell.
bool is_mostly_closed(const MeshMoments& moments) {
  return 2 * moments.closed_area >= moments.surface.measure;
}

InsideFindings findings_of(const Adjacency& adjacency, const SolidFaces& solid) {
  InsideFindings out;
  out.num_double_faces = solid.num_double;
  out.num_flipped_faces = solid.num_flipped;
  for (size_t c = 0; c < solid.closed.size(); ++c) {
    // Open parts weigh nothing in a solid's mass, which the user should know.
    out.num_open_parts += !solid.closed[c];
    out.num_turned_parts += solid.closed[c] && adjacency.components[c].winding < 0;
  }
  return out;
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
  // A hull with volume is next best; without one, the points themselves have to do.
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
  // An empty mesh keeps its zeros.
  if (mesh.vertices.empty()) {
    out.rule = MassRule::Hull;
    return out;
  }
  const Aabb box = mesh.box();
  const Vec3 origin = box.centre();
  const SolidFaces solid = solid_faces(mesh, adjacency);
  const MeshMoments moments = integrate(mesh, adjacency, solid, origin);
  out.area = moments.surface.measure;
  out.findings = findings_of(adjacency, solid);
  const bool has_solid = is_solid(moments, box);
  // Open parts beside a solid leave two rules: the distance of their centres tells how much they
  // differ.
  if (has_solid && out.findings.num_open_parts > 0)
    out.findings.other_centre_distance = (moments.solid.centre() - moments.surface.centre()).norm();
  // The best rule that holds is taken: the solid, the surface, the hull.
  if (has_solid && is_mostly_closed(moments)) {
    out.volume = moments.solid.measure;
    set_centre(out, MassRule::Volume, moments.solid, origin);
  } else if (out.area > 0) {
    set_centre(out, MassRule::Surface, moments.surface, origin);
  } else {
    set_hull(out, mesh, origin);
  }
  // A mesh of one point has no radius, and rounding may leave none: the box's stands in.
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
