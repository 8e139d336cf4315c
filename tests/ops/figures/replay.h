// Motions of an operation, checked against all pairs of faces.
#pragma once

#include <vector>

#include "ops/operations/stage.h"
#include "support/settle_options.h"

namespace trivet::test {

/// The motion from one pose to another, with its length in `limit`. Turns are about the axis common
/// to both poses.
Motion motion_between(const Pose& from, const Pose& to, SettleStep::Kind kind);

/// Clearance for all figures, the same in every scene.
inline constexpr double kFigureClearance = 2e-6;
inline SettleOptions figure_options(bool literal_paper_rules = false) {
  SettleOptions options = perfect_friction();
  options.clearance = kFigureClearance;
  options.literal_paper_rules = literal_paper_rules;
  return options;
}

/// Checks the steps of an object from `start`: every fall ends where brute force over all pairs of
/// faces stops it, no turn passes that point, and a turn that ends earlier ends at the lowest
/// centre of mass.
void expect_true_steps(const Scene& scene, const std::string& name, Pose start,
                       const std::vector<SettleStep>& steps);

/// Stop of an object falling from `start`, by all pairs of faces.
Pose dropped(const Scene& scene, const std::string& name, const Pose& start);

}  // namespace trivet::test
