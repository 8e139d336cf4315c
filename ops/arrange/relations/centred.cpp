#include "ops/arrange/relations/centred.h"

#include <algorithm>
#include <cmath>

namespace trivet::relations {

std::vector<Field<Centred>> Centred::fields() {
  return {{"along", &Centred::along, "Direction: b's right, b's back, or both (default)."},
          {"offset", &Centred::offset}};
}

double Centred::cost(const Terms& r, const Outline& a, const Outline* b) const {
  // Offsets are along b's own axes: right, and away from its front.
  const Vec2 off = a.centre - b->centre;
  const double x = std::abs(off.dot(b->right()) - offset.x());
  const double y = std::abs(off.dot(-b->front) - offset.y());
  return std::max(along.x ? x : 0, along.y ? y : 0) / r.tolerance;
}

std::vector<HalfPlane> Centred::half_planes(const Terms&, const Placed& both, double slack) const {
  const Outline &a = both.a(), &b = both.b();
  const Vec2 off = a.centre - b.centre;
  std::vector<HalfPlane> out;
  const auto add = [&](const Vec2& d, double wanted) {
    add_interval(d, both.sign(), off.dot(d), wanted - slack, wanted + slack, out);
  };
  if (along.x) add(b.right(), offset.x());
  if (along.y) add(-b.front, offset.y());
  return out;
}

double Centred::most_apart(const Terms& r, const Sizes& sizes) const {
  return along.x && along.y ? offset.norm() + 2 * r.tolerance + sizes.a + sizes.b + sizes.touching
                            : kInfinity;
}

}  // namespace trivet::relations
