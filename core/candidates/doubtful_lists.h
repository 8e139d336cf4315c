// Between two stages of z-lists: pixels that depths alone leave in doubt, and the lists made there.
//
// The paper's composition [Shinya 1995, 5.1]: depths per pixel from graphics hardware, then
// complete lists in software, but only in the pixels that the depths do not settle. The two
// stages share only the frame.
#pragma once

#include "core/candidates/zlist_frame.h"
#include "core/candidates/zlist_stage.h"

namespace trivet {

/// Lists where the depths of a query leave doubt.
struct Doubt {
  /// row * frame.width + column, each once. Of every pair of faces whose first contact is no later
  /// than `upper`, the point of the fixed face that is met first lies in one of these pixels.
  std::vector<std::uint32_t> pixels;
  double upper = kInfinity;  // difference of depths by which something touches, see ZListFrame
};

/// Makes complete lists in doubtful pixels, and pairs of faces from them. Not re-entrant.
class DoubtfulLists {
 public:
  virtual ~DoubtfulLists() = default;
  /// @param frame  of the query, not empty.
  /// @return as CandidateFinder::find_candidates(), for the frame's horizon.
  virtual CandidatePairs find_candidates(const FirstContactQuery& query, const ZListFrame& frame,
                                         const Doubt& doubt) = 0;
};

}  // namespace trivet
