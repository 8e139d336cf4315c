// Values that the result of an operation depends on; journals keep them.
#pragma once

namespace trivet {

/// Clearance of motions and end of settling. Lengths in metres.
struct SettleOptions {
  /// Clearance at which motions stop; 0: 2^-20 of the scene's size or largest coordinate.
  double clearance = 0;
  /// The paper's three cases literally, for comparison, instead of the enumerated Gauss principle.
  bool literal_paper_rules = false;
  /// Refuse an operation that needs more motions.
  int max_motions = 5000;
  /// Accept an object that can neither move nor be shown to be supported, as ObjectState::Wedged;
  /// otherwise the operation is refused.
  bool accept_wedged = false;
};

}  // namespace trivet
