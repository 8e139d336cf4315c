// A move that follows a hand: an operation on its way, of which nothing is in the scene until it
// ends. What it commits is what perform() of its operation() would, to the bit.
//
// PUSH and TRANSLATE go on from where they are, round what is in the way, and keep the way in
// `via`; what goes along one line or about one axis (PICK-UP, TURN, ROTATE, and what is free) goes
// anew from the start each time, so that the hand can take it back.
#pragma once

#include <memory>

#include "ops/move/attempt.h"

namespace trivet {

class LiveMove {
 public:
  /// @param scene  outlives this, and nobody changes it meanwhile.
  /// @param operation  PUSH, TURN, PICK-UP, TRANSLATE or ROTATE; how far does not matter.
  /// @param options  without a time budget.
  LiveMove(Scene& scene, const Operation& operation, const SettleOptions& options);
  ~LiveMove();
  LiveMove(LiveMove&&) noexcept;

  /// result() says why; nothing moves any more.
  bool refused() const;
  const OperationResult& result() const;  // of what was done last: end, blocked_by, ...
  const SettleOptions& options() const;
  double clearance() const;  // metres, at which it stops; 0 when there is no such object

  /// PUSH: where the object's position shall be, seen from above (z does not matter). TRANSLATE:
  /// how far it shall be from where it was at the start.
  void follow(const Vec3& goal);
  /// TURN and ROTATE: degrees from the start. PICK-UP: metres.
  void follow(double amount);

  bool has_moved() const;
  /// Where the object and what it carries are, the object first.
  std::vector<Placement> placements() const;
  /// Of what moves, with what does not.
  std::vector<ContactPoint> contacts() const;

  /// That leads here.
  const Operation& operation() const;
  /// Commits. Once, and nothing else after it.
  OperationResult finish();

 private:
  class Hand;
  std::unique_ptr<Hand> m_hand;
};

}  // namespace trivet
