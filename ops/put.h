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
  enum class Kind { Fall, TurnAboutPoint, TurnAboutLine, Lift };
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

  bool ok() const { return status == Status::Ok; }
};

/// The whole operation or nothing: when refused, the scene is as it was.
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
