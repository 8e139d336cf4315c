#include "ops/arrange/relations/aligned.h"

#include <cmath>

namespace trivet::relations {

double turned_from(const Vec2& a, const Vec2& b, double period_deg) {
  const double angle = angle_between_deg(a, b);
  return std::abs(angle - period_deg * std::floor(angle / period_deg + 0.5));
}

}  // namespace trivet::relations
