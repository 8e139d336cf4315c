// Judges the result of a simulation: crossings by exact signs, depth and gap by brute force in
// double.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/contact/triangle_distance.h"
#include "core/exact/interpenetration.h"
#include "perf/scenes.h"
#include "perf/settling.h"

namespace trivet::perf {
namespace {

constexpr int kSampleSplits = 4;  // of the meshes' edges, for sample points

struct Surface {
  std::vector<Triangle> triangles;
  std::vector<Aabb> boxes;
  Aabb box;

  Surface(const Shape& shape, const Positions& positions) {
    for (const Index3& t : shape.mesh.triangles) {
      triangles.push_back({positions[t[0]], positions[t[1]], positions[t[2]]});
      Aabb around;
      for (const Vec3& p : triangles.back()) around.extend(p);
      boxes.push_back(around);
      box.extend(around);
    }
  }
};

bool far(const Aabb& a, const Aabb& b, double distance) { return !overlaps(a, b, distance); }

// Smallest distance of a triangle (or point) from a surface, if below `best`.
double nearer(const Triangle& t, const Surface& surface, double best) {
  Aabb box;
  for (const Vec3& p : t) box.extend(p);
  for (size_t i = 0; i < surface.triangles.size(); ++i)
    if (!far(box, surface.boxes[i], best))
      best = std::min(best, closest_points(t, surface.triangles[i]).distance);
  return best;
}

// Solid angle of all faces, over 4 pi [van Oosterom 1983].
double winding_number(const Vec3& p, const Surface& surface) {
  double half_angles = 0;
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return half_angles / (2 * std::numbers::pi);
}

// Depth of the deepest sample point of a mesh inside a closed surface.
double depth_inside(const Mesh& mesh, const Affine& m, const Surface& surface) {
  double deepest = 0;
  for (const Vec3& vertex : refined(mesh, kSampleSplits).vertices) {
    const Vec3 p = m.apply(vertex);
    Aabb box;
    box.extend(p);
    if (far(box, surface.box, 0) || winding_number(p, surface) < 0.5) continue;
    deepest = std::max(deepest, nearer({p, p, p}, surface, kInfinity));
  }
  return deepest;
}

}  // namespace

Remains judge(const Object& moving, const Pose& pose, const Object& fixed) {
  const Affine ma = world_from_object(pose, moving.up, moving.scale);
  const Affine mb = fixed.world_from_object();
  const Positions pa = world_positions(*moving.shape, ma), pb = world_positions(*fixed.shape, mb);
  const Surface a(*moving.shape, pa), b(*fixed.shape, pb);
  Remains out;
  out.crossings =
      count_crossings({moving.shape.get(), &pa, ma, 0}, {fixed.shape.get(), &pb, mb, 0});
  out.depth = std::max({depth_inside(moving.shape->mesh, ma, b),
                        depth_inside(fixed.shape->mesh, mb, a), -a.box.lower.z()});
  if (out.crossings > 0 || a.box.lower.z() <= 0) return out;
  out.gap = a.box.lower.z();
  for (const Triangle& t : a.triangles) out.gap = nearer(t, b, out.gap);
  return out;
}

}  // namespace trivet::perf
