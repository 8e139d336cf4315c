// The motions of an operation, judged by all pairs of faces.
#pragma once

#include <vector>

#include "ops/move/stage.h"

namespace trivet::test {

/// The motion that leads from one pose to another: of how far, in `limit`. Turns are about the axis
/// that the two poses have in common.
Motion motion_between(const Pose& from, const Pose& to, SettleStep::Kind kind);

/// What figures are put down with: the same clearance in every scene.
inline constexpr double kFigureClearance = 2e-6;
inline SettleOptions figure_options(bool literal_paper_rules = false) {
  SettleOptions options;
  options.clearance = kFigureClearance;
  options.literal_paper_rules = literal_paper_rules;
  return options;
}

/// Goes through the steps of an object from `start`: every fall ends where brute force over all
/// pairs of faces says it must, no turn goes on beyond it, and one that ends before it ends where
/// the centre of mass is lowest.
void expect_true_steps(const Scene& scene, const std::string& name, Pose start,
                       const std::vector<SettleStep>& steps);

/// Where an object would stop that comes down from `start`: all pairs of faces.
Pose dropped(const Scene& scene, const std::string& name, const Pose& start);

}  // namespace trivet::test
