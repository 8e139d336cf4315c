#include "ops/arrange/arrange.h"

#include <algorithm>

#include "ops/arrange/contradictions.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/solver.h"
#include "ops/base/stopwatch.h"

namespace trivet {

const char* to_string(ArrangeResult::Status status) {
  constexpr const char* kNames[] = {"done", "conflict", "cancelled", "out of time"};
  return kNames[static_cast<int>(status)];
}

Sentence ArrangeResult::sentence() const {
  switch (status) {
    case Status::Done:
      return {};
    case Status::Conflict:
      return conflict ? conflict->text : Sentence();
    case Status::Cancelled:
      return TRIVET_SENTENCE("the arrangement was cancelled");
    case Status::OutOfTime:
      break;
  }
  return TRIVET_SENTENCE("the arrangement did not end in time");
}

namespace {

// Before anything is placed: what contradicts each other wherever things stand.
bool contradicts(const World& world, ArrangeResult& out) {
  try {
    out.conflict = find_contradiction(world);
  } catch (const ArrangeStopped&) {
    return false;  // the solver says so
  }
  if (out.conflict) out.status = ArrangeResult::Status::Conflict;
  return out.conflict.has_value();
}

// Other seeds would end the same way: it is certain, or the second time that a thing found no place
// at all, or that the same two were in each other's way.
bool is_hopeless(const Conflict& conflict, const std::optional<Conflict>& before,
                 const Solver& solver) {
  if (conflict.is_certain || !before) return conflict.is_certain;
  const bool is_same = before->thing == conflict.thing &&
                       in_english(before->constraints) == in_english(conflict.constraints);
  if (is_same && !solver.has_stood(conflict.thing)) return true;
  const auto both = [](const Conflict& c) {
    return c.objects.size() == 1 ? std::minmax(c.thing, c.objects.front())
                                 : std::minmax(c.thing, c.thing);
  };
  return conflict.objects.size() == 1 && both(conflict) == both(*before);
}

}  // namespace

ArrangeResult arrange(Transaction& transaction, const Arrangement& arrangement,
                      const SettleOptions& options, const RunContext& context,
                      const ArrangeProgress& progress) {
  const Stopwatch stopwatch;
  ArrangeResult out;
  Interrupt interrupt(context);
  RunContext each = context;
  each.time_budget_s = 0;  // of the whole, not of each PUT
  ShapeFacts facts;
  std::optional<Conflict> before;  // of the last attempt
  // Each attempt works in a transaction of its own, which only a whole arrangement commits.
  for (int attempt = 0; attempt < std::max(1, arrangement.max_attempts); ++attempt) {
    Transaction trial(transaction);
    World world(trial, arrangement, {options, each, &interrupt, &facts});
    out.conflict.reset();
    ++out.num_attempts;
    // Bounds alone may already show that nothing can work; this is asked once, as it does not
    // depend on the seed.
    if (attempt == 0 && contradicts(world, out)) {
      out.milliseconds = stopwatch.milliseconds();
      return out;
    }
    // Attempts differ by their seed alone, so that the first good one repeats.
    const std::uint64_t seed = scrambled(arrangement.seed ^ scrambled(attempt));
    Solver solver(world, seed, interrupt, progress, out);
    if (solver.run()) {
      // All stand: what soft relations still cost is lowered, as long as time is left.
      solver.improve();
      if (interrupt.reason() == Interrupt::Reason::Cancelled) {
        out.status = ArrangeResult::Status::Cancelled;
        return out;
      }
      solver.finish();
      trial.commit();
      out.milliseconds = stopwatch.milliseconds();
      return out;
    }
    out.milliseconds = stopwatch.milliseconds();
    // An attempt that was stopped is no conflict.
    if (out.status != ArrangeResult::Status::Done) return out;
    if (out.conflict && is_hopeless(*out.conflict, before, solver)) break;
    before = out.conflict;
  }
  out.status = ArrangeResult::Status::Conflict;
  return out;
}

ArrangeResult arrange(Scene& scene, const Arrangement& arrangement, const SettleOptions& options,
                      const RunContext& context, const ArrangeProgress& progress) {
  Transaction transaction(scene);
  ArrangeResult out = arrange(transaction, arrangement, options, context, progress);
  if (out.ok()) transaction.commit();
  return out;
}

}  // namespace trivet
