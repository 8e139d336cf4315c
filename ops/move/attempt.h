// What all operations share that move a group: refusals, motions that stop at collision, letting
// go, and the commit.
#pragma once

#include <optional>

#include "ops/move/commit_group.h"
#include "ops/operation.h"
#include "ops/stopwatch.h"

namespace trivet {

/// Why motions may not keep that far apart in this scene; empty: they may.
/// @param usual  the default clearance.
std::string why_not_clearance(double clearance, double usual);

/// One operation on its way: first refused() or moved, then finish().
class Attempt {
 public:
  /// Refused at once: an object (or what it carries) that is fixed or locked; a clearance that is
  /// none; an object (or one of `together`) that is out of the scene or interpenetrates (`free`
  /// may).
  /// @param op  its name.
  Attempt(Scene& scene, ObjectId id, const JointMoveOptions& move, const char* op,
          const SettleOptions& options, bool free = false);
  /// Of a PUT from `start`: the object may be out of the scene.
  Attempt(Scene& scene, ObjectId id, const MoveOptions& move, const Pose& start,
          const SettleOptions& options);

  bool refused() const { return !m_result.ok(); }
  void refuse(const std::string& reason);
  /// Refused when the operation is to stop; asked between motions.
  bool interrupted();

  const Scene& scene() const { return m_scene; }
  MovingGroup& group() { return *m_group; }
  const MovingGroup& group() const { return *m_group; }
  OperationResult& result() { return m_result; }
  const OperationResult& result() const { return m_result; }
  const SettleOptions& options() const { return m_options; }
  std::string name() const;  // quoted

  /// Goes as far as collision allows; what stopped it is noted.
  /// @return the time; below the motion's limit when something is in the way.
  double advance(const Motion& motion, SettleStep::Kind kind);
  void note_step(SettleStep::Kind kind);
  void note_blocked(const FirstContact& found);
  void note_blocked(Index outside, const Vec3& point);

  /// Settles from where the group is. Refused when it cannot come to rest. What moved `together` is
  /// let go one after another when the group is committed, the lowest first.
  void let_go();
  bool is_joint() const { return m_joint; }  // several things in one hand
  bool lets_go_each() const { return m_joint && m_let_go; }
  /// The same in two steps: the group is where it settled, and may go back.
  SettleOutcome settle() { return m_group->settle(&m_interrupt); }
  void end_settled(const SettleOutcome& outcome);
  /// Commits and does what MoveOptions ask for. @param otherwise  the state when it does not rest.
  OperationResult finish(ObjectState otherwise);
  OperationResult finish_freely();

 private:
  // Refused, or a group is made. @param started  a PUT's object, where it starts.
  void begin(ObjectId id, const std::vector<ObjectId>& together,
             const std::vector<PlacedBox>& started);
  std::string why_not_startable(bool free) const;
  OperationResult done();

  Scene& m_scene;
  const MoveOptions& m_move;
  const char* m_op;
  const SettleOptions& m_options;
  Interrupt m_interrupt;
  OperationResult m_result;
  std::optional<MovingGroup> m_group;
  bool m_is_put = false, m_joint = false, m_let_go = false, m_wedged = false;
  Stopwatch m_stopwatch;
};

}  // namespace trivet
