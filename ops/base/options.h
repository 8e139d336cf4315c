// Values that the result of an operation depends on; journals keep them.
#pragma once

namespace trivet {

/// Clearance of motions and end of settling. Lengths in metres.
struct SettleOptions {
  /// Clearance at which motions stop; 0: 2^-20 of the scene's size or largest coordinate.
  double clearance = 0;
  /// The paper's three cases literally, for comparison, instead of the enumerated Gauss principle.
  bool literal_paper_rules = false;
  /// Settle with (nearly) perfect friction, as the paper does; otherwise by materials.
  bool perfect_friction = true;
  /// Judge the connected part of the scene as a whole after an operation: what does not stand gives
  /// way, or the operation is refused.
  bool whole_at_rest = false;
  /// Refuse an operation that needs more motions.
  int max_motions = 5000;
  /// Accept an object that can neither move nor be shown to be supported, as ObjectState::Wedged;
  /// otherwise the operation is refused.
  bool accept_wedged = false;
};

}  // namespace trivet
