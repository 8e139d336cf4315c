#include "ops/arrange/relations/within.h"

#include <algorithm>

namespace trivet::relations {
namespace {

// Normal of the side from this corner on.
Vec2 outwards(const std::vector<Vec2>& region, size_t corner) {
  const Vec2 along = (region[(corner + 1) % region.size()] - region[corner]).normalized();
  return -quarter_turned(along);
}

}  // namespace

std::vector<Field<Within>> Within::fields() {
  return {{"region", &Within::region,
           "Two opposite corners of a rectangle, or the corners of a convex polygon, "
           "counter-clockwise.",
           true}};
}

double Within::cost(const Terms& r, const Outline& a, const Outline*) const {
  double out = 0;
  // The region is convex: each side bounds the outline's extent across it.
  for (size_t i = 0; i < region.size(); ++i) {
    const Vec2 way = outwards(region, i);
    out = std::max(out, extent(a.hull, way) - way.dot(region[i]));
  }
  return out / r.tolerance;
}

std::vector<HalfPlane> Within::half_planes(const Terms&, const Placed& both, double slack) const {
  std::vector<HalfPlane> out;
  out.reserve(region.size());
  for (size_t i = 0; i < region.size(); ++i) {
    const Vec2 way = outwards(region, i);
    out.push_back({way, way.dot(region[i]) + slack - extent(both.moving.hull, way)});
  }
  return out;
}

void Within::extend(Aabb& box) const {
  for (const Vec2& p : region) box.extend(Vec3(p.x(), p.y(), 0));
}

}  // namespace trivet::relations
