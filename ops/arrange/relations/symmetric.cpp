#include "ops/arrange/relations/symmetric.h"

#include <algorithm>

namespace trivet::relations {
namespace {

constexpr double kMirroredDeg = 2;  // of a front against the mirror image of another

}  // namespace

std::vector<Field<Symmetric>> Symmetric::fields() {
  return {{"about", &Symmetric::middle},
          {"point", &Symmetric::point},
          {"axis", Direction<Symmetric>{&Symmetric::axis}}};
}

double Symmetric::cost(const Terms& r, const Outline& a, const Outline* b) const {
  // Place and front have to mirror each other, each by its own tolerance.
  const double off = (a.centre - mirrored_point(b->centre)).norm();
  const double turned = angle_between_deg(a.front, mirrored_direction(b->front));
  return std::max(off / r.tolerance, turned / kMirroredDeg);
}

std::vector<HalfPlane> Symmetric::half_planes(const Terms&, const Placed& both,
                                              double slack) const {
  return planes_about(mirrored_point(both.other->centre) - both.moving.centre, slack);
}

std::vector<Rotation> Symmetric::turns(const Outline& moving, const Outline& other) const {
  return {turn_between(moving.front, mirrored_direction(other.front))};
}

void Symmetric::extend(Aabb& box) const {
  if (point) box.extend(Vec3(point->x(), point->y(), 0));
}

void Symmetric::set_about(const Outline& outline) {
  point = outline.centre;
  axis = outline.front;
}

const char* Symmetric::wrong(const Terms&, const IsGiven& is_given) const {
  const bool has_point = is_given("point"), has_axis = is_given("axis");
  // The plane comes from an object or from a point with an axis, never from both.
  const bool has_plane = has_point && has_axis, has_part = has_point || has_axis;
  return (middle.empty() ? !has_plane : has_part)
             ? TRIVET_SENTENCE("accepted: either \"about\" an object, or \"point\" and \"axis\"")
             : nullptr;
}

}  // namespace trivet::relations
