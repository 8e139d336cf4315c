#include "ops/operations/inside.h"

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

bool has_walls_around(const Vec3& point, const Body& container) {
  int walls = 0;
  for (int i = 0; i < kDirections; ++i) {
    // Off the axes, along which walls have their edges.
    const Vec3 way =
        turn_about(Vec3::UnitZ(), (i + 0.5) * (360.0 / kDirections)).matrix() * Vec3::UnitX();
    walls += std::any_of(std::begin(kHeights), std::end(kHeights), [&](double height) {
      return first_hit(*container.shape, container.world_from_object,
                       {point + height * Vec3::UnitZ(), way})
          .has_value();
    });
  }
  return 2 * walls > kDirections;
}

Body body_of_object(const Object& object) {
  return Body(*object.shape, object.world_from_object());
}

}  // namespace

bool is_inside(const Body& thing, const Body& container) {
  Vec3 lowest = Vec3::Constant(kInfinity);
  for (const Vec3& vertex : thing.shape->mesh.vertices)
    if (const Vec3 p = thing.world_from_object.apply(vertex); p.z() < lowest.z()) lowest = p;
  return has_walls_around(lowest, container);
}

bool is_inside(const Object& thing, const Object& container) {
  return is_inside(body_of_object(thing), body_of_object(container));
}

bool is_container(const Object& object) {
  const Body body = body_of_object(object);
  Vec3 above = 0.5 * (body.world_box.lower + body.world_box.upper);
  above.z() = body.world_box.upper.z();
  const Ray down{above, -Vec3::UnitZ()};
  const auto ground = first_hit(*object.shape, body.world_from_object, down);
  return ground && has_walls_around(down.at(ground->time), body);
}

}  // namespace trivet
