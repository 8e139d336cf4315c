#include "apps/edit/tools/picking.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

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

constexpr double kRingsPx[] = {1.5, 3, 4.5, 6};  // of points that are tried around a click
constexpr double kNearestPx = 3;                 // for thin objects beside other ones
constexpr double kThinPx = 8;                    // radius in which a thin object covers little
constexpr double kThinShare = 0.36;              // an edge of a wide one covers half

std::vector<Vec2> ring(double radius, int count) {
  std::vector<Vec2> out;
  out.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    out.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return out;
}

/// A click, and what is seen around it.
class NearPick {
 public:
  NearPick(const SceneSnapshot& scene, const View& view, const std::vector<ObjectId>& except)
      : m_scene(scene), m_view(view), m_except(except) {}

  std::optional<Picked> at(const Vec2& px) const {
    return pick(m_scene, m_view.seen_ray(px), m_except);
  }

  /// True if an object that is seen at `px` covers little of what is around there.
  bool is_thin(ObjectId id, const Vec2& px) const {
    int covered = 0, all = 0;
    for (const double radius : {kThinPx / 2, kThinPx})
      for (const Vec2& aside : ring(radius, 12)) {
        const auto seen = at(px + aside);
        covered += seen && seen->object == id;
        ++all;
      }
    return covered < kThinShare * all;
  }

 private:
  const SceneSnapshot& m_scene;
  const View& m_view;
  const std::vector<ObjectId>& m_except;
};

/// True if a click on `hit` may mean an object `other` beside it.
bool gives_way(const SceneSnapshot& scene, const std::optional<Picked>& hit, ObjectId other) {
  const ObjectSnapshot* const there = hit && hit->object ? scene.find(*hit->object) : nullptr;
  if (!there || (*there)->fixed) return true;
  for (const ObjectContact& entry : (*scene.find(other))->contacts)
    if (entry.with == Support(there->id) && holds_up(entry)) return true;
  return false;
}

bool is_one_of(const std::optional<Picked>& picked, const std::vector<ObjectId>& objects) {
  return picked && picked->object &&
         std::find(objects.begin(), objects.end(), *picked->object) != objects.end();
}

}  // namespace

std::optional<Picked> pick_near(const SceneSnapshot& scene, const View& view, const Vec2& px,
                                const std::vector<ObjectId>& except) {
  const NearPick near(scene, view, except);
  auto exact = near.at(px);
  const bool on_object = exact && exact->object;
  for (const double radius : kRingsPx)
    for (const Vec2& aside : ring(radius, 8)) {
      if (on_object && radius > kNearestPx) return exact;
      auto seen = near.at(px + aside);
      if (!seen || !seen->object || (on_object && seen->object == exact->object)) continue;
      if (!on_object || near.is_thin(*seen->object, px + aside)) return seen;
    }
  return exact;
}

std::optional<Picked> pick_to_drag(const SceneSnapshot& scene, const View& view, const Vec2& px,
                                   const std::vector<ObjectId>& selected,
                                   const std::vector<ObjectId>& except) {
  const NearPick near(scene, view, except);
  auto exact = near.at(px);
  if (is_one_of(exact, selected)) return exact;
  std::optional<Picked> beside;
  for (const double radius : kRingsPx)
    for (const Vec2& aside : ring(radius, 8)) {
      auto seen = near.at(px + aside);
      if (is_one_of(seen, selected) && gives_way(scene, exact, *seen->object)) return seen;
      if (!beside && seen && seen->object) beside = seen;
    }
  return exact && exact->object ? exact : beside ? beside : exact;
}

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
                                  const Vec2& opposite, const std::vector<ObjectId>& except) {
  const Vec2 lower = corner.cwiseMin(opposite), upper = corner.cwiseMax(opposite);
  const auto inside = [&](const Vec3& p) {
    if (view.cut && view.depth(p) < *view.cut) return false;
    const auto px = view.project(p);
    return px && (px->array() >= lower.array()).all() && (px->array() <= upper.array()).all();
  };
  std::vector<ObjectId> out;
  for (const ObjectSnapshot& o : scene.objects) {
    if (!o->placed || std::find(except.begin(), except.end(), o.id) != except.end()) continue;
    const Affine world = o->world_from_object();
    const std::vector<Vec3>& vertices = o->shape->mesh.vertices;
    const auto num_inside = std::count_if(vertices.begin(), vertices.end(),
                                          [&](const Vec3& v) { return inside(world.apply(v)); });
    if (2 * static_cast<size_t>(num_inside) >= vertices.size()) out.push_back(o.id);
  }
  return out;
}

}  // namespace trivet::edit
