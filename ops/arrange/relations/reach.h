#pragma once

#include "ops/arrange/relations/sight.h"

namespace trivet::relations {

/// a is no farther from there than the gap's upper end, the way to it free.
struct Reach : Looking, Gap {
  static constexpr const char* kName = "reach";
  static constexpr const char* kHelp =
      "a is no farther from there than an arm's length (default 0.7 m), and the way to it is free; "
      "tolerance 1 cm by default.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 in reach of %2");
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 in reach of its point");
  static constexpr double kUsualUpper = 0.7;  // an arm
  static std::vector<Field<Reach>> fields();

  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  double most_apart(const Terms& r, const Sizes& sizes) const {
    return eye ? kInfinity : upper + r.tolerance + sizes.b + sizes.touching;
  }
  double length() const { return upper; }
  double missing(const Sight& sight) const { return sight.nearest() - upper; }
  bool holds(const Terms& r, const Sight& sight) const;
};

}  // namespace trivet::relations
