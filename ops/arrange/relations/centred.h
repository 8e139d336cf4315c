#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// a's centre is b's plus `offset`, along b's right, b's back, or both.
struct Centred : AnyKind {
  static constexpr const char* kName = "centred";
  static constexpr const char* kHelp =
      "a's centre is b's plus the offset; tolerance 1 cm by default.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 centred %2");
  static constexpr double kUsualTolerance = 0.01;
  static std::vector<Field<Centred>> fields();

  double cost(const Terms& r, const Outline& a, const Outline* b) const;
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  bool is_decided_by_planes() const { return true; }
  double most_apart(const Terms& r, const Sizes& sizes) const;

  Axes along;
  Vec2 offset = Vec2::Zero();
};

}  // namespace trivet::relations
