#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// a's outline is in `region`.
struct Within : AnyKind {
  static constexpr const char* kName = "within";
  static constexpr const char* kHelp = "a's outline is in the region.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 within %2");
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 within its region");
  static constexpr Other kOther = Other::None;
  static std::vector<Field<Within>> fields();

  double cost(const Terms& r, const Outline& a, const Outline* b) const;
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  bool is_decided_by_planes() const { return true; }
  void extend(Aabb& box) const;

  std::vector<Vec2> region;  // convex, counter-clockwise
};

}  // namespace trivet::relations
