// The z-lists of one motion, for display: depth images, bounds, and the pairs of faces that
// were left for the exact decision.
#pragma once

#include "core/candidates/zlist_stage.h"
#include "raster/zlist/motion_depths.h"

namespace trivet {

struct MotionZLists {
  MotionDepths depths;        // by software, whatever the source of the pairs
  double floor = kInfinity;   // time of the contact with the floor, up to which the others matter
  CandidatePairs candidates;  // proposed by the stage, less those that Embree does not visit
  FirstContact contact;       // the answer, the same bits whatever the stage
  /// The first of these, by `not_before`: those that their bounds did not rule out either when the
  /// first contact was decided.
  size_t num_confirmed = 0;

  std::span<const FacePair> confirmed() const { return {candidates.pairs.data(), num_confirmed}; }
  /// Bounds of the first contact, by depths and floor: infinity as in MotionDepths.
  double lower() const { return std::min(depths.lower, floor); }
  double upper() const { return std::min(depths.upper, floor); }
};

/// @param stage  proposes the pairs; where it gives up, `candidates` are not usable and
///   none are confirmed.
/// @param resolution  of the depth images; see motion_depths().
MotionZLists motion_zlists(const FirstContactQuery& query, CandidateFinder& stage, int resolution,
                           const Confirmation& confirmation = kConfirmAll);

}  // namespace trivet
