#include "apps/edit/tools/picking.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace trivet::edit {
namespace {

bool misses(const Aabb& box, const Ray& ray, double until) {
  double enter = 0, leave = until;
  for (int k = 0; k < 3; ++k) {
    const double lower = box.lower[k] - ray.origin[k], upper = box.upper[k] - ray.origin[k];
    if (ray.direction[k] == 0) {
      if (lower > 0 || upper < 0) return true;
      continue;
    }
    const double a = lower / ray.direction[k], b = upper / ray.direction[k];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return enter > leave * (1 + 1e-12) + 1e-12;
}

Vec3 facing_normal(const Object& object, Index face, const Ray& ray) {
  const Affine world = object.world_from_object();
  const Triangle t = object.shape->mesh.triangle(face);
  const Vec3 a = world.apply(t[0]);
  const Vec3 n = (world.apply(t[1]) - a).cross(world.apply(t[2]) - a);
  const double length = n.norm();
  if (!(length > 0)) return -ray.direction.normalized();
  return (n.dot(ray.direction) > 0 ? -1 : 1) * n / length;
}

}  // namespace

std::optional<Picked> pick(const SceneSnapshot& scene, const Ray& ray,
                           const std::vector<ObjectId>& except) {
  std::optional<Picked> best;
  if (scene.floor && ray.direction.z() < 0 && ray.origin.z() >= 0) {
    const double time = -ray.origin.z() / ray.direction.z();
    best = Picked{std::nullopt, ray.at(time), Vec3::UnitZ(), 0, time};
    best->point.z() = 0;
  }
  for (const ObjectSnapshot& o : scene.objects) {
    if (!o->placed || std::find(except.begin(), except.end(), o.id) != except.end()) continue;
    const double until = best ? best->time : kInfinity;
    if (misses(world_box(*o.object), ray, until)) continue;
    const auto hit = first_hit(*o->shape, o->world_from_object(), ray, until);
    if (!hit || !(hit->time < until)) continue;
    best = Picked{o.id, ray.at(hit->time), facing_normal(*o.object, hit->face, ray), hit->face,
                  hit->time};
  }
  return best;
}

std::vector<ObjectId> pick_in_box(const SceneSnapshot& scene, const View& view, const Vec2& corner,
                                  const Vec2& opposite) {
  const Vec2 lower = corner.cwiseMin(opposite), upper = corner.cwiseMax(opposite);
  const auto inside = [&](const Vec3& p) {
    const auto px = view.project(p);
    return px && (px->array() >= lower.array()).all() && (px->array() <= upper.array()).all();
  };
  std::vector<ObjectId> out;
  for (const ObjectSnapshot& o : scene.objects) {
    if (!o->placed) continue;
    const Affine world = o->world_from_object();
    const std::vector<Vec3>& vertices = o->shape->mesh.vertices;
    if (inside(o->centre_of_mass()) ||
        std::any_of(vertices.begin(), vertices.end(),
                    [&](const Vec3& v) { return inside(world.apply(v)); }))
      out.push_back(o.id);
  }
  return out;
}

}  // namespace trivet::edit
