// Interactive move: an operation that follows a hand. Nothing changes in the scene until it ends;
// then it commits what perform() of its operation() would, to the bit.
//
// PUSH and TRANSLATE go on from where they are, round obstacles, and keep the way in `via`; moves
// along one line or about one axis (PICK-UP, TURN, ROTATE, and free ones) start anew each time, so
// that the hand can take them back.
#pragma once

#include <memory>

#include "core/scene/transaction.h"
#include "ops/operations/perform.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

class LiveMove {
 public:
  /// @param scene  outlives this, and does not change meanwhile.
  /// @param operation  PUSH, TURN, PICK-UP, TRANSLATE, ROTATE or MOVE_JOINT; its extent is
  ///   ignored.
  /// @param context  its time budget is ignored.
  LiveMove(const Scene& scene, const Operation& operation, const SettleOptions& options,
           const RunContext& context = {});
  ~LiveMove();
  LiveMove(LiveMove&&) noexcept;

  /// See result(). A refused move does not move any more.
  bool refused() const;
  const OperationResult& result() const;  // of the last motion: end, blocked_by, ...
  const SettleOptions& options() const;
  double clearance() const;  // metres, at which it stops; 0 when there is no such object

  /// PUSH: target of the object's position in the two axes of the push (z is ignored). TRANSLATE:
  /// offset from where the object was at the start.
  void follow(const Vec3& goal);
  /// TURN and ROTATE: degrees from the start. PICK-UP: metres. MOVE_JOINT: value of the joint.
  void follow(double amount);

  bool has_moved() const;
  /// Poses of the object and its loads, the object first.
  std::vector<Placement> placements() const;
  /// Contacts of the group with the outside, one per pair of objects.
  std::vector<Contact> contacts() const;
  /// The group as it is now, the object first.
  std::span<const Body> bodies() const;

  /// The operation that leads here.
  const Operation& operation() const;
  /// Commits; the scene is the one that this was made for. Once, and nothing else after it.
  OperationResult finish(Scene& scene);
  OperationResult finish(Transaction& transaction);

 private:
  class Hand;
  std::unique_ptr<Hand> m_hand;
};

}  // namespace trivet
