#include "ops/mend/neighbours.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ops/placement/verify.h"

namespace trivet {
namespace {

constexpr size_t kMostNeighbours = 64;  // of one way
constexpr double kFootShare = 0.02;     // of its height: the part on which an object stands
constexpr double kTipsThatWay = 0.3;    // cosine to the way in which it would tip

bool is_related(const ObjectIntent& o, ObjectId other) {
  return o.inside == other || std::any_of(o.on.begin(), o.on.end(), [&](const auto& s) {
           return !s.on.is_floor() && s.on.object() == other;
         });
}

// From its foot to its centre of mass, seen from above: so it would tip.
Vec2 tipping_way(const Object& object) {
  const Affine world = object.world_from_object();
  Aabb box;
  for (const Vec3& v : object.shape->mesh.vertices) box.extend(world.apply(v));
  const double foot = box.lower.z() + kFootShare * (box.upper.z() - box.lower.z());
  Aabb stands;
  for (const Vec3& v : object.shape->mesh.vertices)
    if (const Vec3 p = world.apply(v); p.z() <= foot) stands.extend(p);
  return (object.centre_of_mass() - stands.centre()).head<2>();
}

}  // namespace

IntendedNeighbours intended_neighbours(const Scene& scene, const Intent& intent,
                                       const ObjectIntent& o) {
  const Object& object = scene.at(o.id);
  const Vec2 tips = o.is_level ? Vec2::Zero() : tipping_way(object);
  const double h = std::sqrt(0.5);
  const Vec2 ways[] = {{1, 0}, {h, h}, {0, 1}, {-h, h}, {-1, 0}, {-h, -h}, {0, -1}, {h, -h}};
  std::map<std::uint32_t, std::pair<ObjectId, bool>> met;  // true: it leans on it
  for (const Vec2& way : ways) {
    Placement shifted{o.id, object.pose};
    shifted.pose.translation.head<2>() += intent.tolerance * way;
    const bool tips_there = tips.dot(way) > kTipsThatWay * tips.norm();
    for (const Interpenetration& x :
         interpenetrations(scene, {&shifted, 1}, false, kMostNeighbours)) {
      if (x.with.is_floor() || is_related(o, x.with.object())) continue;
      const ObjectIntent* const other = intent.find(x.with.object());
      if (other && is_related(*other, o.id)) continue;
      met.try_emplace(x.with.object().index, x.with.object(), false).first->second.second |=
          tips_there;
    }
  }
  IntendedNeighbours out;
  for (const auto& [index, neighbour] : met)
    (neighbour.second ? out.leans_on : out.beside).push_back(neighbour.first);
  return out;
}

}  // namespace trivet
