#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// A side of a is at a gap from b.
struct Against : AnyKind, Gap {
  static constexpr const char* kName = "against";
  static constexpr const char* kHelp = "A side of a is at this gap from b; default 0 to 1 cm.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 against %2");
  static constexpr bool kIsBeside = true, kTurnsOnlyA = true;
  static constexpr double kUsualUpper = 0.01;
  static std::vector<Field<Against>> fields();

  /// Towards which a's side looks, turned round.
  Vec2 direction(const Outline& a, const Outline& b) const;
  double cost(const Terms& r, const Outline& a, const Outline* b) const;
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  bool is_decided_by_planes() const { return true; }
  const Gap* gap() const { return this; }
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const {
    return turns_to(moving, other.front, 1);
  }
  double most_apart(const Terms& r, const Sizes& sizes) const;
  double length() const { return upper; }

  double overlap = 0.5;      // of a's side
  std::optional<Side> side;  // of a; nullopt: its back
};

}  // namespace trivet::relations
