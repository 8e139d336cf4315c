// The order in which meant supports let objects be placed. Private.
#pragma once

#include <vector>

#include "ops/mend/intent.h"

namespace trivet {

/// An object that has no place in the order yet.
struct OpenIntent {
  ObjectIntent intent;
  double lowest = 0;  // metres, of its underside
};

/// Supports and containers before what they carry; of the others standing ones before leaning ones,
/// then the lower ones. A circle loses its weakest support.
std::vector<ObjectIntent> lower_first(std::vector<OpenIntent> objects);

}  // namespace trivet
