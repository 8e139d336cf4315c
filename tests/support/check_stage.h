// The same random queries for every z-list stage, GPU or software.
#pragma once

#include "support/random_queries.h"

namespace trivet::test {

/// Statistics of a stage's answers.
struct StageCheck {
  int num = 0;
  int num_contacts = 0;                           // of the truth
  int num_crossings = 0;                          // faces cross at the start
  int num_upper = 0;                              // contacts for which the stage had an upper bound
  int num_unusable = 0;                           // gave up, or was proved wrong
  std::int64_t num_pairs = 0, num_all_pairs = 0;  // proposed; faces x faces
  std::vector<std::string> failures;              // difference and query; the first few
  std::vector<std::string> reasons;               // of unusable answers; the first few

  std::string describe() const;
};

/// Runs queries number first .. first + num - 1 with the stage and compares with BVHs and brute
/// force, bit for bit; checks the bounds, the order of the pairs and that none occurs twice. The
/// last quarter are groups of bodies over the floor.
StageCheck check_stage(CandidateFinder& stage, const MeshPool& pool, unsigned seed, int first,
                       int num);

}  // namespace trivet::test
