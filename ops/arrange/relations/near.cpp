#include "ops/arrange/relations/near.h"

namespace trivet::relations {

std::vector<Field<Near>> Near::fields() { return {{"distance", GapForm::Either, "", true}}; }

double Near::distance(const Outline& a, const Outline& b) const {
  return trivet::distance(a.hull, b.hull, lower > 0 ? 0 : upper);
}

}  // namespace trivet::relations
