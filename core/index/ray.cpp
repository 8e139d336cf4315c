// Watertight ray-triangle test [Woop 2013], in double: triangles are projected
// along the ray's largest direction into one plane, in which neighbours share their edge functions.
#include "core/index/ray.h"

#include <array>
#include <cmath>

namespace trivet {
namespace {

constexpr double kGrown = 1e-9;  // of the largest coordinate: boxes hold every possible hit

/// Ray in the object's frame, with the same times.
struct LocalRay {
  Vec3 origin, direction;
  std::array<int, 3> axis;  // the last is the largest of the direction
  Vec3 shear;

  LocalRay(const Affine& world_from_object, const Ray& ray) {
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
      const Vec3 p = t[i] - origin;
      x[i] = p[axis[0]] - shear[0] * p[axis[2]];
      y[i] = p[axis[1]] - shear[1] * p[axis[2]];
      z[i] = shear[2] * p[axis[2]];
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kInfinity;
    const double sum = u + v + w;
    if (sum == 0) return kInfinity;
    const double time = (u * z[0] + v * z[1] + w * z[2]) / sum;
    return time >= 0 ? time : kInfinity;
  }

  /// Whether the ray may hit the box before `until`.
  bool may_meet(const Aabb& box, double until) const {
    const double margin = kGrown * std::max(box.max_abs_coordinate(), origin.cwiseAbs().maxCoeff());
    double enter = 0, leave = until;
    for (int k = 0; k < 3; ++k) {
      const double lower = box.lower[k] - margin - origin[k];
      const double upper = box.upper[k] + margin - origin[k];
      if (direction[k] == 0) {
        if (lower > 0 || upper < 0) return false;
        continue;
      }
      const double a = lower / direction[k], b = upper / direction[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }
};

void keep_earlier(const LocalRay& ray, const Mesh& mesh, Index face, double until,
                  std::optional<RayHit>& best) {
  const double time = ray.meets(mesh.triangle(face));
  if (!(time < kInfinity) || time > until) return;
  if (!best || time < best->time || (time == best->time && face < best->face))
    best = RayHit{time, face};
}

}  // namespace

std::optional<RayHit> first_hit(const Shape& shape, const Affine& world_from_object, const Ray& ray,
                                double until) {
  std::optional<RayHit> best;
  if (!shape.has_faces()) return best;
  const Bvh& bvh = shape.bvh();
  const LocalRay local(world_from_object, ray);
  std::array<Index, kMaxBvhDepth + 1> stack;
  size_t num_waiting = 0;
  stack[num_waiting++] = 0;
  while (num_waiting > 0) {
    const Index id = stack[--num_waiting];
    const BvhNode& node = bvh.nodes[id];
    if (!local.may_meet(node.box(), best ? best->time : until)) continue;
    if (node.is_leaf()) {
      for (Index i = 0; i < node.num_faces; ++i)
        keep_earlier(local, shape.mesh, bvh.faces[node.second_child + i], until, best);
      continue;
    }
    stack[num_waiting++] = node.second_child;
    stack[num_waiting++] = id + 1;
  }
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
