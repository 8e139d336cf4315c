#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// The distance of a from b is in the gap.
struct Near : AnyKind, Gap {
  static constexpr const char* kName = "near";
  static constexpr const char* kHelp =
      "Outlines are no farther apart than this, or their distance is between both.";
  static constexpr const char* kAlias = "next_to";
  static constexpr const char* kAliasHelp = "The same; default 10 cm.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 near %2");
  static constexpr double kUsualUpper = 0.1;
  static std::vector<Field<Near>> fields();

  /// Metres between the outlines; what is no more than the gap's upper end may be anything up to
  /// that, where it has no lower one.
  double distance(const Outline& a, const Outline& b) const;
  /// Cost at that distance.
  double cost_at(const Terms& r, double distance) const {
    return outside(distance, lower, upper) / r.tolerance;
  }

  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return cost_at(r, distance(a, *b));
  }
  std::vector<HalfPlane> half_planes(const Terms&, const Placed& both, double slack) const {
    return planes_near(both.moving, *both.other, upper + slack);
  }
  const Gap* gap() const { return this; }
  double most_apart(const Terms& r, const Sizes& sizes) const {
    return upper + r.tolerance + sizes.touching;
  }
  double length() const { return upper; }
};

}  // namespace trivet::relations
