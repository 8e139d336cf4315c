// Rules of settling other than the default ones, which some tests are about.
#pragma once

#include "ops/base/options.h"

namespace trivet::test {

/// The paper's settling: with (nearly) perfect friction, each object alone.
inline SettleOptions perfect_friction() {
  SettleOptions options;
  options.perfect_friction = true;
  return options;
}

/// With the materials' friction, each object alone: what nothing holds any more is named, and
/// stays.
inline SettleOptions objects_alone() {
  SettleOptions options;
  options.whole_at_rest = false;
  return options;
}

}  // namespace trivet::test
