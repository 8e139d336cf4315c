#pragma once

#include "ops/arrange/relations/sight.h"

namespace trivet::relations {

/// b is above so much of a's outline.
struct Under : AnyKind {
  static constexpr const char* kName = "under";
  static constexpr const char* kHelp = "b is above this part of a, seen from above.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 under %2");
  static constexpr double kUsualTolerance = 0.01;
  static constexpr bool kIsOfSight = true, kHasLines = false;
  static std::vector<Field<Under>> fields();

  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  double most_apart(const Terms& r, const Sizes& sizes) const {
    return part > 2 * r.tolerance ? sizes.touching : kInfinity;
  }
  double missing(const Sight& sight) const { return part - sight.covered(); }
  bool holds(const Terms& r, const Sight& sight) const {
    return sight_cost_of(r, missing(sight)) <= 1;
  }

  double part = 0.5;
};

}  // namespace trivet::relations
