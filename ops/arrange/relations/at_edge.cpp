#include "ops/arrange/relations/at_edge.h"

#include <algorithm>

namespace trivet::relations {
namespace {

constexpr Side kAllSides[] = {Side::Front, Side::Back, Side::Left, Side::Right};

// From a side of b to a's outline, inwards.
double edge_gap(const Outline& a, const Outline& b, Side side) {
  const Vec2 d = direction_of_side(b, side);
  return extent(b.hull, d) - extent(a.hull, d);
}

}  // namespace

std::vector<Field<AtEdge>> AtEdge::fields() {
  return {{"side", &AtEdge::side, "Side of b; default: any."}, {"gap", GapForm::Both}};
}

// At its side, or the nearest; inside all others.
double AtEdge::cost(const Terms& r, const Outline& a, const Outline* b) const {
  // The outline has to be inside all sides; its distance from the side it is meant for counts.
  double least = kInfinity, between = kInfinity;
  for (const Side each : kAllSides) {
    const double here = edge_gap(a, *b, each);
    least = std::min(least, here);
    if (!side || *side == each) between = std::min(between, here);
  }
  return std::max(outside(between, lower, upper), std::max(0.0, -least)) / r.tolerance;
}

// Inside b's sides, as far as they are known.
std::vector<HalfPlane> AtEdge::half_planes(const Terms&, const Placed& both, double slack) const {
  const Outline &a = both.a(), &b = both.b();
  std::vector<HalfPlane> out;
  for (const Side each : kAllSides) {
    const bool at = side == each;
    // b's extent less a's grows as b goes along it.
    add_interval(direction_of_side(b, each), -both.sign(), edge_gap(a, b, each),
                 (at ? lower : 0) - slack, at ? upper + slack : kInfinity, out);
  }
  return out;
}

}  // namespace trivet::relations
