#include "ops/arrange/relations/reach.h"

namespace trivet::relations {
namespace {

Outline point_outline(const Vec2& p) {
  Outline out;
  out.hull = {p};
  out.centre = p;
  return out;
}

}  // namespace

std::vector<Field<Reach>> Reach::fields() {
  return {{"height", &Reach::eye_height, kEyeHeightHelp, false, -kMaxLength, kMaxLength},
          {"point", &Reach::eye, kEyeHelp},
          {"distance", GapForm::Most}};
}

// The eye no farther from a than it reaches, seen from above.
std::vector<HalfPlane> Reach::half_planes(const Terms&, const Placed& both, double slack) const {
  if (!both.moves_a)
    return planes_near(point_outline(both.moving.centre), *both.other, upper + slack);
  return planes_near(both.moving, point_outline(place(both.other).head<2>()), upper + slack);
}

bool Reach::holds(const Terms& r, const Sight& sight) const {
  return sight.reaches([&](double distance) { return sight_cost_of(r, distance - upper) <= 1; });
}

}  // namespace trivet::relations
