#include "ops/arrange/relations/kind.h"

#include <algorithm>
#include <cmath>

namespace trivet {

const char* to_string(Side side) {
  constexpr const char* kNames[] = {"front", "back", "left", "right"};
  return kNames[static_cast<int>(side)];
}

namespace relations {

double outside(double value, double lower, double upper) {
  return std::max({0.0, lower - value, value - upper});
}

void add_interval(const Vec2& d, double sign, double known, double lower, double upper,
                  std::vector<HalfPlane>& out) {
  if (upper < kInfinity) out.push_back({sign * d, upper - known});
  if (lower > -kInfinity) out.push_back({-sign * d, known - lower});
}

std::vector<HalfPlane> planes_about(const Vec2& at, double slack) {
  std::vector<HalfPlane> out;
  out.reserve(4);
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    out.push_back({d, d.dot(at) + slack});
  return out;
}

std::vector<HalfPlane> planes_near(const Outline& moving, const Outline& other, double upper) {
  std::vector<HalfPlane> out;
  // Eight directions bound the distance from outside: no place within it is lost.
  const double s = std::sqrt(0.5);
  for (const Vec2& d : {Vec2(1, 0), Vec2(s, s), Vec2(0, 1), Vec2(-s, s), Vec2(-1, 0), Vec2(-s, -s),
                        Vec2(0, -1), Vec2(s, -s)})
    add_interval(d, 1, -extent(moving.hull, -d) - extent(other.hull, d), -kInfinity, upper, out);
  return out;
}

Vec2 direction_of_side(const Outline& b, Side side) {
  switch (side) {
    case Side::Front:
      return b.front;
    case Side::Back:
      return -b.front;
    case Side::Left:
      return -b.right();
    case Side::Right:
      break;
  }
  return b.right();
}

Rotation turn_between(const Vec2& from, const Vec2& to) {
  // Opposite directions are half a turn apart, either way round.
  const double cosine = from.dot(to);
  if (1 + cosine < 1e-12) return {0, 0, 0, 1};
  return Rotation{1 + cosine, 0, 0, cross(from, to)}.normalized();
}

std::vector<Rotation> turns_to(const Outline& moving, Vec2 front, int step) {
  std::vector<Rotation> out;
  for (int quarter = 0; quarter < 4; ++quarter, front = quarter_turned(front))
    if (quarter % step == 0) out.push_back(turn_between(moving.front, front));
  return out;
}

}  // namespace relations

}  // namespace trivet
