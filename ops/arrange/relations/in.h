#pragma once

#include "ops/arrange/relations/kind.h"

namespace trivet::relations {

/// b and what lies in it carry a, its centre over b; not on the rim of b: see is_inside().
struct In : AnyKind {
  static constexpr const char* kName = "in";
  static constexpr const char* kHelp = "b and what lies in it carry a.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 in %2");
  static constexpr bool kCarries = true;

  double most_apart(const Terms&, const Sizes& sizes) const { return sizes.touching; }
};

}  // namespace trivet::relations
