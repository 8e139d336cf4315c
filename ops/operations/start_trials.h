// Starts of a PUT, and how it ends from each.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/scene/transaction.h"
#include "ops/detect/detector.h"
#include "ops/operations/container.h"
#include "ops/operations/move_plan.h"
#include "ops/operations/put.h"
#include "ops/operations/whole.h"

namespace trivet {

inline constexpr int kStartsOfTry = 2;  // looked at for each try: some interpenetrate, most topple
/// Tried whatever they cost: most PUTs are done by then.
inline constexpr int kLeastStarts = 3;
/// The time in which most PUTs are done; no result depends on it.
inline constexpr std::chrono::milliseconds kShortPut{50};
/// From other starts than the first the whole has to stand at once. A fifth of them do, which costs
/// a fifth of what moving others does to place as many.
inline constexpr Budget kBudgetToStand{40, 0};

/// A start of the sequence. @param number  1: the one that was asked for.
/// @param part  of its shift.
StartTried start_to_try(const Object& object, const PutOperation& o, int number, double part = 1);

/// Centre of mass of the object at a pose, world.
Vec3 centre_at(const Object& object, const Pose& pose);

/// The start interpenetrates something.
bool starts_blocked(const OperationResult& result);

/// A PUT in two steps, of which the second may be tried again by a larger budget.
struct PutSteps {
  std::function<MovePlan(const Scene&, const PutOperation&, OperationRun&)> plan;
  std::function<OperationResult(Transaction&, MovePlan, Budget, OperationRun&)> commit;
  /// Threads that may call these at once, each with a run and a scene of its own.
  int num_threads = 1;
};

/// A start with the place where the object settles from it, which no budget changes.
struct SettledStart {
  StartTried start;
  MovePlan plan;
};

/// A commit from a start, taken back.
struct StartTrial {
  SettledStart settled;
  OperationResult result;
  bool leaves = false;                             // came to rest out of its container
  bool across_gap = false;                         // came to rest, but touches too little
  std::vector<std::pair<ObjectId, Object>> after;  // the objects that it changes, if it rests

  bool rests() const { return result.ok() && !leaves && !across_gap; }
  /// It rests, or the operation is to stop: no later start is needed.
  bool is_last() const {
    return rests() || (!result.ok() && result.status != OperationResult::Status::Refused);
  }
};

/// Tries the starts of a PUT, each on its own. With several threads the next ones are tried ahead
/// on copies of the scene: that costs time of other cores alone, and changes no result.
class StartTrials {
 public:
  /// @param transaction, o, put, run  outlive it. Between calls the scene is the same.
  StartTrials(Transaction& transaction, ObjectId id, const PutOperation& o, const PutSteps& put,
              OperationRun& run);
  ~StartTrials();
  StartTrials(const StartTrials&) = delete;
  StartTrials& operator=(const StartTrials&) = delete;

  /// All starts are tried until one stands, whatever that costs.
  void want_all() { m_wants_all = true; }

  /// Other threads begin with start 2 and the next ones while the caller goes on.
  void begin();

  /// From now on a rest across a gap is as good as any.
  void accept_gaps() { m_accepts_gaps = true; }

  /// As far from the first start as it is free and in the container, with kBudgetToStand: trials of
  /// those that are blocked, then that of the one that is not, if there is one.
  /// @param number  of the start, from 2 on; one more than that of the call before.
  std::vector<StartTrial> next(int number);

  /// Up to the first that is_last().
  std::vector<StartTrial> all(std::vector<SettledStart> starts, Budget budget);

  /// Lets the scene be as after the trial, which rests.
  void take(StartTrial& trial);

 private:
  using Trials = std::vector<StartTrial>;
  using TryOne = std::function<Trials(size_t k, Transaction& transaction, OperationRun& run)>;
  /// The trials of one start, by a detector of its own if there is one.
  struct Tried {
    Trials trials;
    Detector* detector = nullptr;
  };
  class AtOnce;
  struct Begun;

  int num_ahead(int number) const;
  TryOne from_number(int number) const;
  std::deque<Tried> end_begun();
  Trials counted(Tried tried) const;
  std::deque<Tried> try_each(size_t count, const TryOne& try_one);
  Trials try_number(int number, Transaction& transaction, OperationRun& run) const;
  StartTrial try_from(SettledStart settled, Budget budget, Transaction& transaction,
                      OperationRun& run) const;

  Transaction& m_transaction;
  const ObjectId m_id;
  const PutOperation& m_operation;
  const PutSteps& m_put;
  OperationRun& m_run;
  const Container m_container;
  bool m_wants_all = false, m_accepts_gaps = false;
  std::deque<Detector> m_detectors;  // plans refer to them
  std::deque<Tried> m_ahead;
  std::unique_ptr<Begun> m_begun;
};

SettledStart settle_from(const Scene& scene, const PutOperation& o, const PutSteps& put,
                         OperationRun& run, const StartTried& start);

}  // namespace trivet
