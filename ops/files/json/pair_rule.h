// Rules for pairs of objects as layouts have them: by names.
#pragma once

#include <string>

#include "core/scene/pair_rules.h"

namespace trivet {

/// A rule for two objects by name, of which one may be the floor.
struct NamedPairRule {
  std::string a, b;
  PairRule rule;

  friend bool operator==(const NamedPairRule&, const NamedPairRule&) = default;
};
}  // namespace trivet
