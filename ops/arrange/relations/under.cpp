#include "ops/arrange/relations/under.h"

namespace trivet::relations {

std::vector<Field<Under>> Under::fields() { return {{"part", &Under::part, kPartHelp}}; }

// b's outline over a's, at least by a point.
std::vector<HalfPlane> Under::half_planes(const Terms&, const Placed& both, double slack) const {
  const Outline &moving = both.moving, &other = *both.other;
  std::vector<HalfPlane> out;
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    add_interval(d, 1, -extent(moving.hull, -d) - extent(other.hull, d), -kInfinity, slack, out);
  return out;
}

}  // namespace trivet::relations
