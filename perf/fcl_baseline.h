// FCL's continuous collision on the same motions, for comparison.
#pragma once

#include <memory>
#include <string>

#include "perf/sweeps.h"

namespace trivet::perf {

/// FCL's CCDSolverType, and a hand-written loop over distance(). (FCL's ray shooting is empty, and
/// its polynomial solver moves vertices of the object's frame by the world's velocity, which is
/// meaningless for rotated objects.)
enum class FclSolver {
  Naive,                    // collide() at evenly spaced samples
  ConservativeAdvancement,  // its own; known not to work for meshes (FCL issues 119, 120, 555)
  DistanceLoop,             // distance(), then move by that much, until within our clearance
};

struct FclAnswer {
  bool found = false;
  double time = kInfinity;  // as of our Motion
};

/// The meshes of a pair in FCL's form.
class FclPair {
 public:
  virtual ~FclPair() = default;
  /// @param samples  of the whole motion; for FclSolver::Naive.
  virtual FclAnswer sweep(const Sweep& sweep, FclSolver solver, int samples) const = 0;
};

/// Uses BVHModel<OBBRSS<double>>; null in a build without FCL.
std::unique_ptr<FclPair> make_fcl_pair(const SpherePair& spheres);
std::string fcl_version();  // "0.7.0", or a note that it was left out

}  // namespace trivet::perf
