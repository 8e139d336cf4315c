#include "ops/arrange/relations/view.h"

namespace trivet::relations {

std::vector<Field<View>> View::fields() {
  return {{"height", &View::eye_height, kEyeHeightHelp, false, -kMaxLength, kMaxLength},
          {"point", &View::eye, kEyeHelp},
          {"part", &View::part, kPartHelp}};
}

bool View::holds(const Terms& r, const Sight& sight) const {
  return sight.sees([&](double seen) { return sight_cost_of(r, part - seen) <= 1; });
}

}  // namespace trivet::relations
