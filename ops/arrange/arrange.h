// Computer-aided layout: objects and relations in, poses at rest out, or why not.
//
//   order      supports and what relations refer to first (solver.cpp)
//   places     height maps and relations on one grid, sampled by cost with noise (placer.h)
//   patterns   in closed form (slots.h)
//   PUT        the judge of every place; relations again where it came to rest
//   look ahead what had no place once gets one when its references are put (solver.cpp)
//   evict      what is in the way, or what relations refer to, weighted, with nogoods; restarts
//   improve    soft costs, one thing after the other, once all stand (improve.cpp)
//   conflict   the smallest set of constraints that leaves no place (conflict.h)
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/conflict.h"

namespace trivet {

struct ArrangeResult {
  enum class Status { Done, Conflict, Cancelled, OutOfTime };
  Status status = Status::Done;
  std::optional<Conflict> conflict;

  struct Placed {
    std::string object;
    OperationResult result;  // of its PUT
  };
  std::vector<Placed> placed;  // in the order of their last PUTs; Done only
  struct Holds {
    std::string relation;
    bool hard = true;
    double cost = 0;  // in tolerances
  };
  std::vector<Holds> relations;  // all but those of support; Done only

  int num_puts = 0, num_refused = 0, num_evictions = 0, num_attempts = 0;
  int num_improvements = 0;                       // things moved for soft relations
  double milliseconds = 0, put_milliseconds = 0;  // of the whole; of all PUTs

  bool ok() const { return status == Status::Done; }
  Sentence sentence() const;  // empty: done
  std::string reason() const { return in_english(sentence()); }
};
const char* to_string(ArrangeResult::Status status);  // "done", "conflict", ...

/// Told before each thing: its name, how many stand, how many there are.
using ArrangeProgress = std::function<void(const std::string&, size_t, size_t)>;

/// Places all things so that all hard relations hold and all is at rest, or nothing: the scene is
/// as it was then (the transaction, when it is given, as well). The result depends on the
/// arrangement, its seed and the scene, on no number of threads. Every loop is bounded. By
/// context.time_budget_s, of the whole, it may end early.
/// @throws Error (BadInput) for what cannot be meant: unknown things, cycles of supports, ...
ArrangeResult arrange(Scene& scene, const Arrangement& arrangement, const SettleOptions& options,
                      const RunContext& context, const ArrangeProgress& progress = {});
ArrangeResult arrange(Transaction& transaction, const Arrangement& arrangement,
                      const SettleOptions& options, const RunContext& context,
                      const ArrangeProgress& progress = {});

}  // namespace trivet
