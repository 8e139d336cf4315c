// PUT: from a start pose down along gravity to the first contact, then settle [Shinya 1995, 4.1].
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace trivet {

class Detector;

/// How motions keep apart and when settling stops. Lengths in metres.
struct SettleOptions {
  /// Clearance at which motions stop; 0: 2^-20 of the scene's size or largest coordinate.
  double clearance = 0;
  /// The paper's three cases literally, for comparison, instead of the enumerated Gauss principle.
  bool literal_paper_rules = false;
  /// More motions than this: refused, naming the limit.
  int max_motions = 5000;
  /// Accept an object that can neither move nor be shown to be supported, as ObjectState::Wedged;
  /// otherwise the operation is refused.
  bool accept_wedged = false;
  /// What answers when motions first touch; null: box trees. Not owned; results do not depend on
  /// it.
  Detector* detector = nullptr;
  /// Set by another thread to stop the operation; null: nobody does. Not owned. See interrupt.h.
  const std::atomic<bool>* cancel = nullptr;
  /// Seconds that an operation may take, asked between motions; 0: as long as it needs.
  double time_budget_s = 0;
};

/// One executed motion of a settling, for those who want to watch.
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

struct OperationResult {
  enum class Status {
    Ok,
    Refused,    // by the geometry
    Cancelled,  // by SettleOptions::cancel
    OutOfTime,  // by SettleOptions::time_budget_s
  };
  Status status = Status::Ok;
  std::string reason;  // of a refusal, geometric: names the objects
  int num_motions = 0;
  double milliseconds = 0;                           // wall clock
  std::int64_t num_queries = 0, num_face_pairs = 0;  // first-contact queries, exact pairs
  std::vector<SettleStep> steps;

  /// Why it ended; means nothing when refused.
  enum class End {
    Done,     // nothing moves: append, delete, lock, ...
    AtRest,   // PUT: it settled
    Reached,  // as far as was asked for
    Blocked,  // by `blocked_by` at `blocked_at`
    Step,     // the same, by a step higher than step_up
    Edge,     // before an edge deeper than step_down; pulled back
  };
  End end = End::AtRest;
  std::string blocked_by;                    // an object, or "floor"
  Vec3 blocked_at = Vec3::Zero();            // world
  double moved = 0;                          // metres from where its position was
  double turned_deg = 0;                     // by TURN and ROTATE
  std::vector<std::string> carried;          // what moved with it
  std::vector<std::string> unsupported;      // free objects that nothing holds any more
  std::vector<std::string> settled;          // that were let go, in order
  std::vector<std::string> interpenetrates;  // after a free move; "floor" too

  bool ok() const { return status == Status::Ok; }
};

const char* to_string(
    OperationResult::End end);  // "done", "at_rest", "reached", "blocked", "step", "edge"

/// The whole operation or nothing: when refused, the scene is as it was. Loads are carried along.
/// Refused: the start pose crosses, contains or is inside another object or reaches below the
/// floor; nothing is below it; it wedges; a limit is reached; the exact check of the end pose
/// fails.
OperationResult put(Scene& scene, ObjectId object, const Pose& start,
                    const SettleOptions& options = {});

/// Places an object where the layout says it stands from the start: checked like every end pose,
/// but not settled. Fixed objects become ObjectState::Fixed; free ones are Stable if at rest there,
/// else Wedged.
OperationResult stand(Scene& scene, ObjectId object, const Pose& pose,
                      const SettleOptions& options = {});

}  // namespace trivet
