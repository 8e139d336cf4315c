#include "ops/arrange/relations/beside.h"

#include <algorithm>

namespace trivet::relations {

bool closes(const Terms& r, const Gap& gap) {
  return r.is_hard() && gap.lower >= 0 && gap.upper == 0;
}

double beside_cost(const Terms& r, const Gap& gap, const Vec2& d, double wanted, const Outline& a,
                   const Outline& b) {
  const Vec2 across = quarter_turned(d);
  // The gap runs along the direction, the overlap across it.
  const double between = -extent(a.hull, -d) - extent(b.hull, d);
  const double overlap = std::min(extent(a.hull, across), extent(b.hull, across)) +
                         std::min(extent(a.hull, -across), extent(b.hull, -across));
  return std::max(outside(between, gap.lower, gap.upper), std::max(0.0, wanted - overlap)) /
         r.tolerance;
}

std::vector<HalfPlane> beside_planes(const Terms& r, const Gap& gap, const Vec2& d, double wanted,
                                     const Placed& both, double slack) {
  const Outline &a = both.a(), &b = both.b();
  const double sign = both.sign();
  const Vec2 across = quarter_turned(d);
  std::vector<HalfPlane> out;
  // PUSH to contact begins before it.
  const double sooner = closes(r, gap) ? 0.5 * r.tolerance : 0;
  add_interval(d, sign, -extent(a.hull, -d) - extent(b.hull, d), gap.lower - slack + sooner,
               gap.upper + slack + sooner, out);
  const double least = wanted - slack;
  // Nowhere, where either is too narrow for that.
  const double room = std::min(a.width(across), b.width(across));
  if (least > room) out.push_back({Vec2::Zero(), room - least});
  // The end of a beyond b's beginning, and the beginning of a before b's end.
  add_interval(across, sign, extent(a.hull, across) + extent(b.hull, -across), least, kInfinity,
               out);
  add_interval(across, sign, -extent(a.hull, -across) - extent(b.hull, across), -kInfinity, -least,
               out);
  return out;
}

double beside_most_apart(const Terms& r, const Gap& gap, const Sizes& sizes) {
  return gap.upper + 2 * r.tolerance + sizes.a + sizes.b + sizes.touching;
}

}  // namespace trivet::relations
