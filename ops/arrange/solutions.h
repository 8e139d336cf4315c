// Several arrangements of one problem that differ from each other.
#pragma once

#include <vector>

#include "ops/arrange/arrange.h"

namespace trivet {

/// Mean over the things of the distance between their centres of mass in two scenes, metres. Things
/// of one model are told apart by their names.
double difference_of(const Scene& a, const Scene& b, const std::vector<Thing>& things);

struct SolutionOptions {
  int count = 1;
  double least_difference = 0.01;  // metres, of each from each other
};

struct Solution {
  std::uint64_t seed = 0;
  Scene scene;
  ArrangeResult result;
  double difference = kInfinity;  // least, from those before
};

struct Solutions {
  std::vector<Solution> found;
  int num_seeds = 0;   // that were tried
  int num_alike = 0;   // arrangements that were too much like one before
  ArrangeResult last;  // of the seed that was tried last
};

/// Arrangements by the seeds that follow the arrangement's own, which comes first: those that
/// differ enough from all before. Tries four seeds for each that is wanted, at most; a conflict of
/// the first ends it. The result is the same with any number of threads.
/// @throws Error as arrange().
Solutions arrange_several(const Scene& scene, const Arrangement& arrangement,
                          const SolutionOptions& wanted, const SettleOptions& options,
                          const RunContext& context, const ArrangeProgress& progress = {});

}  // namespace trivet
