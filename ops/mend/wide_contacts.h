// Contacts across wide gaps, carried along while the bodies move. Private.
#pragma once

#include <vector>

#include "ops/mend/small_motions.h"

namespace trivet {

/// The search of contacts takes ten times as long within 24 mm as within 6 mm. What was found
/// farther than the bodies go in a step is still there after it, nearly: gaps, points and normals
/// move along with the features. What comes near is searched for, and counts instead.
class WideContacts {
 public:
  /// Adds those that are farther than `reach`, metres, to the contacts that were just found within
  /// that, and remembers all.
  void join(double reach, std::vector<BodyContact>& found);
  /// @param gone  of each body, since it was as in `bodies`.
  void move(const std::vector<FreeBody>& bodies, const std::vector<SmallMotion>& gone);

 private:
  std::vector<BodyContact> m_known;
};

}  // namespace trivet
