#include "ops/arrange/relations/against.h"

#include "ops/arrange/relations/beside.h"

namespace trivet::relations {

std::vector<Field<Against>> Against::fields() {
  return {{"side", &Against::side, "Side of a; default back."},
          {"gap", GapForm::Both},
          {"overlap", &Against::overlap}};
}

Vec2 Against::direction(const Outline& a, const Outline&) const {
  return -direction_of_side(a, side.value_or(Side::Back));
}

double Against::cost(const Terms& r, const Outline& a, const Outline* b) const {
  const Vec2 d = direction(a, *b);
  return beside_cost(r, *this, d, overlap * a.width(quarter_turned(d)), a, *b);
}

std::vector<HalfPlane> Against::half_planes(const Terms& r, const Placed& both,
                                            double slack) const {
  const Vec2 d = direction(both.a(), both.b());
  return beside_planes(r, *this, d, overlap * both.a().width(quarter_turned(d)), both, slack);
}

double Against::most_apart(const Terms& r, const Sizes& sizes) const {
  return beside_most_apart(r, *this, sizes);
}

}  // namespace trivet::relations
