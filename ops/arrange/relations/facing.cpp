#include "ops/arrange/relations/facing.h"

namespace trivet::relations {

Vec2 Turned::towards(const Outline& a, const Outline* b, double sign) const {
  const Vec2 to = (point ? *point : b->centre) - a.centre;
  const double length = to.norm();
  // Something right above or below has no direction: the front stays as it is.
  if (!(length > 0)) return a.front;
  return sign > 0 ? Vec2(to / length) : Vec2(-to / length);
}

const char* Turned::wrong(const Terms& r, const IsGiven&) const {
  return r.b.empty() != point.has_value() ? TRIVET_SENTENCE("accepted: either \"b\" or \"point\"")
                                          : nullptr;
}

void Turned::extend(Aabb& box) const {
  if (point) box.extend(Vec3(point->x(), point->y(), 0));
}

std::vector<Field<Facing>> Facing::fields() { return {{"point", &Facing::point}}; }

std::vector<Field<Away>> Away::fields() { return {{"point", &Away::point}}; }

}  // namespace trivet::relations
