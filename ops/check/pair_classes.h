// Pairs of objects in three classes: apart, in contact, passing through each other.
#pragma once

#include <string>
#include <vector>

#include "ops/check/check.h"

namespace trivet {

/// A pair that touches or is closer than kContactTolerance clearances.
struct TouchingPair {
  std::string a, b;  // names; "floor"
  double gap = 0;    // metres; negative: so deep in each other, by rounding
};

struct PairClasses {
  std::vector<TouchingPair> touching;  // in the scene's order
  size_t num_through = 0;              // more than touching
  size_t num_apart = 0;                // all others that could collide

  size_t num_judged() const { return touching.size() + num_through + num_apart; }
};

/// Pairs of fixed objects, and those that may pass through each other, are in no class.
/// @param scene  with its contacts. @param check  of the same scene.
PairClasses pair_classes(const Scene& scene, const SceneCheck& check);

}  // namespace trivet
