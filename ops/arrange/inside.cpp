#include "ops/arrange/inside.h"

#include <algorithm>
#include <iterator>

#include "core/index/ray.h"
#include "core/motion/compose.h"

namespace trivet {
namespace {

constexpr int kDirections = 16;
// Walls are looked for at two heights over the thing's underside, metres: those of a flat saucer
// are low, and those of a drawer may begin above its floor.
constexpr double kHeights[] = {5e-4, 4e-3};

}  // namespace

bool is_inside(const Object& thing, const Object& container) {
  const Affine world = thing.world_from_object();
  Vec3 lowest = Vec3::Constant(kInfinity);
  for (const Vec3& vertex : thing.shape->mesh.vertices)
    if (const Vec3 p = world.apply(vertex); p.z() < lowest.z()) lowest = p;
  const Affine place = container.world_from_object();
  int walls = 0;
  for (int i = 0; i < kDirections; ++i) {
    // Off the axes, along which walls have their edges.
    const Vec3 way =
        turn_about(Vec3::UnitZ(), (i + 0.5) * (360.0 / kDirections)).matrix() * Vec3::UnitX();
    walls += std::any_of(std::begin(kHeights), std::end(kHeights), [&](double height) {
      return first_hit(*container.shape, place, {lowest + height * Vec3::UnitZ(), way}).has_value();
    });
  }
  return 2 * walls > kDirections;
}

}  // namespace trivet
