// Plan of an operation that moves objects: found and verified on copies, not committed.
#pragma once

#include <optional>

#include "ops/operations/move_options.h"
#include "ops/operations/moving_group.h"
#include "ops/operations/operation_run.h"
#include "ops/placement/clearance.h"
#include "ops/placement/verify.h"

namespace trivet {

/// The group where it would be, and the rest of what commit() needs.
struct MovePlan {
  const char* op = "";               // name of the operation
  OperationResult result;            // refused, or as far as it is known without the commit
  std::optional<MovingGroup> group;  // empty only when there is no such object
  bool changes_scene = false;        // there is something to commit
  ObjectState otherwise = ObjectState::Held;  // state of the object when it is not at rest
  bool settled = false;                       // `otherwise` is known to be its state
  std::optional<Refusal> wedged = {};         // unless it comes to rest where the whole gives way
  bool is_free = false;                       // moved through everything
  std::vector<Interpenetration> crossed;      // of a free move
  /// Objects to release after the commit if they are left without support; nullopt: none; an empty
  /// list: all.
  std::optional<std::vector<ObjectId>> release;
};

/// Plans one move: refused(), or moved step by step, then finish(). The scene does not change.
class MovePlanner {
 public:
  /// Refuses at once: an object (or a load) that is fixed or locked; an unusable clearance; an
  /// object (or one of `together`) that is not placed or interpenetrates another.
  /// @param run  outlives the planner. @param op  name of the operation.
  /// @param free  the move may start from an interpenetration.
  MovePlanner(const Scene& scene, ObjectId id, const JointMoveOptions& move, const char* op,
              OperationRun& run, bool free = false);
  /// For a PUT from `start`: the object need not be placed.
  MovePlanner(const Scene& scene, ObjectId id, const MoveOptions& move, const Pose& start,
              OperationRun& run);

  /// For a link in its joint, with what hangs in it.
  MovePlanner(const Scene& scene, ObjectId link, const MoveOptions& move, OperationRun& run);

  bool refused() const { return !m_result.ok(); }
  void refuse(Refusal why) { m_result.refuse(std::move(why)); }
  /// Refuses when the operation is to stop; checked between motions.
  bool interrupted();

  const Scene& scene() const { return m_scene; }
  MovingGroup& group() { return *m_group; }
  const MovingGroup& group() const { return *m_group; }
  OperationResult& result() { return m_result; }
  const OperationResult& result() const { return m_result; }
  const SettleOptions& options() const { return m_run.options; }
  Named name() const { return named(m_scene, Support(m_group->ids()[0])); }

  /// Goes as far as collision allows; the obstacle is noted.
  /// @return the time; below the motion's limit when something is in the way.
  double advance(const Motion& motion, SettleStep::Kind kind);
  void note_step(SettleStep::Kind kind);
  void note_blocked(const Support& by, const Vec3& point);

  /// Settles from where the group is. Refuses when it cannot come to rest. Several objects in one
  /// hand are released one after another once the group is committed, the lowest first.
  void release();
  bool is_joint() const { return m_joint; }  // several objects in one hand
  /// The same in two steps: the group is where it settled, and may go back.
  SettleOutcome settle() { return m_group->settle(&m_run.interrupt); }
  void end_settled(SettleOutcome outcome);

  /// Verifies where the group is. Once; the planner is empty afterwards.
  /// @param otherwise  state of the object when it does not rest.
  MovePlan finish(ObjectState otherwise);
  /// The same for a free move: interpenetrations are noted, not refused.
  MovePlan finish_freely();

 private:
  void begin(ObjectId id, const std::vector<ObjectId>& together,
             const std::vector<PlacedBox>& started);
  std::optional<Refusal> refuse_start(bool free) const;
  SettleOutcome::Status rated(const SettleOutcome& outcome) const;
  bool releases_each() const { return m_joint && m_released; }
  bool is_too_far();
  MovePlan plan();

  const Scene& m_scene;
  OperationRun& m_run;
  const char* m_op;
  bool m_settle_left;
  OperationResult m_result;
  std::optional<MovingGroup> m_group;
  bool m_in_joint = false;
  bool m_is_put = false, m_joint = false, m_released = false, m_wedged = false;
  std::optional<Refusal> m_why_wedged;  // unless it is accepted
};

}  // namespace trivet
