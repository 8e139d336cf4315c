#pragma once

#include "ops/arrange/relations/sight.h"

namespace trivet::relations {

/// So much of what is to be seen of a is seen from there.
struct View : Looking {
  static constexpr const char* kName = "view";
  static constexpr const char* kHelp =
      "This part of what is to be seen of a is seen from b's middle, or a point: nothing else "
      "hides it.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 in view of %2");
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 in view of its point");
  static std::vector<Field<View>> fields();

  double missing(const Sight& sight) const { return part - sight.seen(); }
  bool holds(const Terms& r, const Sight& sight) const;

  double part = 0.5;
};

}  // namespace trivet::relations
