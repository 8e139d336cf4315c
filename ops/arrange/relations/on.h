#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// b, or the floor, alone carries a.
struct On : AnyKind {
  static constexpr const char* kName = "on";
  static constexpr const char* kHelp = "b, or \"floor\", alone carries a; on this level of it.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 on %2");
  static constexpr bool kCarries = true, kTakesFloor = true;
  static std::vector<Field<On>> fields();

  double most_apart(const Terms&, const Sizes& sizes) const { return sizes.touching; }

  std::optional<int> level;  // the support surface, from below; negative: from above; nullopt: any
};

}  // namespace trivet::relations
