// Result of an operation: its motions, why it ended, and the consequences for other objects.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/pose.h"
#include "ops/base/refusal.h"
#include "ops/base/repaired.h"

namespace trivet {

/// One executed motion, for playback.
struct SettleStep {
  enum class Kind {
    Fall,  // settling
    TurnAboutPoint,
    TurnAboutLine,
    Lift,
    Slide,  // along a surface
    StepUp,
    StepDown,
    Move,  // through the air
    Turn,  // as the operation says
  };
  Kind kind;
  Pose pose_after;
  double energy_drop;  // metres that the centre of mass went down; negative for Lift
};

/// An object that an operation moved though it was not asked to: it gave way.
struct GaveWay {
  std::string name;
  double moved = 0;  // metres, of its centre of mass
  double turned_deg = 0;
};

/// Start from which a PUT came to rest, where it is another than the one that was asked for.
struct StartTried {
  int number = 2;         // 1 would be the one that was asked for
  double shifted = 0;     // metres from it, horizontally, of the centre of mass
  double turned_deg = 0;  // about the vertical through the centre of mass
  Pose start;
};

struct OperationResult {
  enum class Status {
    Ok,
    Refused,    // see `refusal`
    Cancelled,  // by RunContext::cancel
    OutOfTime,  // by RunContext::time_budget_s
  };
  Status status = Status::Ok;
  std::optional<Refusal> refusal;  // set unless Ok
  int num_motions = 0;             // its steps, and those of all that gave way, itself too
  double milliseconds = 0;         // wall clock
  std::int64_t num_queries = 0, num_face_pairs = 0;  // first-contact queries, exact pairs
  std::vector<SettleStep> steps;

  /// Reason of its end; meaningless when refused.
  enum class End {
    Done,     // no motion: append, delete, lock, ...
    AtRest,   // PUT: it settled
    Reached,  // as far as was asked for
    Blocked,  // by `blocked_by` at `blocked_at`
    Step,     // the same, by a step that is too high
    Edge,     // before an edge that is too deep; pulled back
    Limit,    // MOVE_JOINT: at the joint's limit
  };
  End end = End::AtRest;
  Named blocked_by;                             // its name is empty when nothing did
  Vec3 blocked_at = Vec3::Zero();               // world
  double moved = 0;                             // metres from where its position was
  double turned_deg = 0;                        // by TURN, ROTATE and MOVE_JOINT
  std::optional<double> joint_value;            // MOVE_JOINT: where it is; metres or degrees
  std::vector<std::string> carried;             // loads and group members that moved along
  std::vector<std::string> unsupported;         // free objects that nothing holds any more
  std::vector<std::string> settled;             // released objects, in order
  std::vector<GaveWay> gave_way;                // in the scene's order
  std::vector<std::string> interpenetrates;     // after a free move; "floor" too
  std::vector<std::string> unsound;             // below it, held, unsupported or invalid
  std::optional<StartTried> tried;              // of a PUT that might try several starts
  std::shared_ptr<const MendedScene> repaired;  // of MEND and SETTLE

  bool ok() const { return status == Status::Ok; }
  /// The refusal as a sentence; empty when there is none.
  std::string reason() const { return refusal ? message(*refusal) : ""; }
  void refuse(Refusal why) {
    status = Status::Refused;
    refusal = std::move(why);
  }
};

/// "done", "at_rest", "reached", "blocked", "step", "edge", "limit"
const char* to_string(OperationResult::End end);

/// A result that is nothing but a refusal.
OperationResult refused(Refusal why);

}  // namespace trivet
