// Embree finds faces whose boxes a ray meets; they are decided here, so that a hit has the same
// bits on every processor. Watertight ray-triangle test [Woop 2013], in double: triangles are
// projected along the ray's largest direction into one plane, in which neighbours share their edge
// functions.
#include "core/index/ray.h"

#include <array>
#include <cmath>

#include "core/index/shape_index.h"

namespace trivet {
namespace {

/// Ray in the object's frame, with the same times.
struct LocalRay {
  Vec3 origin, direction;
  std::array<int, 3> axis;  // the last is the largest of the direction
  Vec3 shear;

  LocalRay(const Affine& world_from_object, const Ray& ray) {
    // Scales are uniform, so that the transpose over the squared scale is the inverse.
    const Mat3& m = world_from_object.linear;
    const double squared_scale = m.col(0).squaredNorm();
    origin = m.transpose() * (ray.origin - world_from_object.translation) / squared_scale;
    direction = m.transpose() * ray.direction / squared_scale;
    int z = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(direction[k]) > std::abs(direction[z])) z = k;
    axis = {(z + 1) % 3, (z + 2) % 3, z};
    shear = Vec3(direction[axis[0]], direction[axis[1]], 1) / direction[z];
  }

  /// Time of the hit; infinity if the ray misses.
  double meets(const Triangle& t) const {
    std::array<double, 3> x, y, z;
    for (int i = 0; i < 3; ++i) {
      // The shear makes the ray the z axis: the triangle is hit if the origin lies inside its
      // projection.
      const Vec3 p = t[i] - origin;
      x[i] = p[axis[0]] - shear[0] * p[axis[2]];
      y[i] = p[axis[1]] - shear[1] * p[axis[2]];
      z[i] = shear[2] * p[axis[2]];
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    // Edge functions of both signs: the origin is outside.
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kInfinity;
    const double sum = u + v + w;
    if (sum == 0) return kInfinity;
    const double time = (u * z[0] + v * z[1] + w * z[2]) / sum;
    return time >= 0 ? time : kInfinity;
  }
};

void keep_earlier(const LocalRay& ray, const Mesh& mesh, Index face, double until,
                  std::optional<RayHit>& best) {
  const double time = ray.meets(mesh.triangle(face));
  // The earliest hit wins, the smallest face among equals.
  if (!(time < kInfinity) || time > until) return;
  if (!best || time < best->time || (time == best->time && face < best->face))
    best = RayHit{time, face};
}

}  // namespace

std::optional<RayHit> first_hit(const Shape& shape, const Affine& world_from_object, const Ray& ray,
                                double until) {
  std::optional<RayHit> best;
  if (!shape.has_faces()) return best;
  const LocalRay local(world_from_object, ray);
  const RayScene& scene =
      shape.index->rays.get([&] { return isolated([&] { return RayScene(shape.mesh); }); });
  scene.visit(local.origin, local.direction, until, [&](Index face) {
    keep_earlier(local, shape.mesh, face, until, best);
    return best ? best->time : until;
  });
  return best;
}

std::optional<RayHit> first_hit_brute_force(const Shape& shape, const Affine& world_from_object,
                                            const Ray& ray, double until) {
  const LocalRay local(world_from_object, ray);
  std::optional<RayHit> best;
  for (Index f = 0; f < static_cast<Index>(shape.mesh.triangles.size()); ++f)
    keep_earlier(local, shape.mesh, f, until, best);
  return best;
}

}  // namespace trivet
