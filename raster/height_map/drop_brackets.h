// Brackets of a falling object's travel, for thousands of places at once: a (min,+) correlation of
// two height maps.
//
// Both maps are drawn once. Moving the object by whole pixels shifts its map, so that at each place
// the fall to first contact is bracketed by
//   lower = min over its pixels of (lower bound of its underside - upper bound of the scene's top),
//   upper = min over its pixels of (its underside - the scene's top) on the line through the
//           pixel's centre, if both are met there.
// The bounds are conservative in coverage and in height, so there is no contact before `lower`; the
// line of `upper` meets both surfaces, so there is a contact by then.
#pragma once

#include <span>
#include <vector>

#include "core/candidates/height_map.h"

namespace trivet {

/// See DropBracketFunction. Uses as many threads as TBB allows; results do not depend on it.
/// Branch and bound over tiles of 8 x 8 pixels: over flat supports and beside other things a place
/// costs about as many steps as the object has tiles, over rough ones three times as many and its
/// pixels.
std::vector<DropBracket> drop_brackets(const HeightMap& object, const HeightMap& scene, int columns,
                                       int rows);

/// Tells if the object falls farther than falls[i] at place i, as far as the bounds tell: exactly
/// where `lower` of drop_brackets() is larger. Costs a fraction of it, as most comparisons are
/// decided by what is highest and lowest under the whole object.
/// @param falls  one for each place; infinity: need not be known, the answer is 0.
std::vector<char> falls_farther(const HeightMap& object, const HeightMap& scene, int columns,
                                int rows, std::span<const float> falls);

/// The same at single places.
class DropProbe {
 public:
  /// @param object  outlives the probe.
  explicit DropProbe(const HeightMap& object);
  DropBracket at(const HeightMap& scene, int column, int row) const;

 private:
  // A run of the object's pixels in one row, non-empty at its first and its last.
  struct RowRun {
    int row, first, last;  // [first, last)
  };

  const HeightMap& m_object;
  std::vector<RowRun> m_runs;
};

}  // namespace trivet
