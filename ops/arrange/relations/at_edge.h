#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// a's outline is inside b's, at a gap from one side of it, or from the nearest one.
struct AtEdge : AnyKind, Gap {
  static constexpr const char* kName = "at_edge";
  static constexpr const char* kHelp =
      "a's outline is inside b's, at this gap (default 0 to 1 cm) from a side of b, or from the "
      "nearest one.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 at_edge %2");
  static constexpr double kUsualUpper = 0.01;
  static std::vector<Field<AtEdge>> fields();

  double cost(const Terms& r, const Outline& a, const Outline* b) const;
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  bool is_decided_by_planes() const { return side.has_value(); }
  double most_apart(const Terms& r, const Sizes& sizes) const {
    return r.tolerance + sizes.touching;
  }
  double length() const { return upper; }

  std::optional<Side> side;  // of b; nullopt: any
};

}  // namespace trivet::relations
