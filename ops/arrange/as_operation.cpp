#include "ops/arrange/as_operation.h"

#include "ops/base/stopwatch.h"

namespace trivet {
namespace {

void add_placed(const ArrangeResult& result, OperationResult& out) {
  // Work of all PUTs of the last attempt adds up to the operation's.
  out.settled.reserve(result.placed.size());
  for (const ArrangeResult::Placed& placed : result.placed) {
    out.settled.push_back(placed.object);
    out.num_motions += placed.result.num_motions;
    out.num_queries += placed.result.num_queries;
    out.num_face_pairs += placed.result.num_face_pairs;
  }
}

Refusal refusal_of(const Conflict& conflict, const Scene& scene) {
  Refusal why{Refusal::Cause::NoArrangement};
  why.objects.reserve(conflict.objects.size() + 1);
  if (scene.find(conflict.thing)) why.objects.push_back(named(scene, conflict.thing));
  for (const std::string& name : conflict.objects) why.objects.push_back(named(scene, name));
  why.numbers = {{"as_things_stand", conflict.as_they_stand ? 1.0 : 0.0}};
  if (conflict.missing) why.numbers.push_back({"missing", *conflict.missing});
  why.detail = conflict.text;
  return why;
}

Refusal stopped(const ArrangeResult& result, const Arrangement& arrangement, double seconds) {
  const bool cancelled = result.status == ArrangeResult::Status::Cancelled;
  Refusal why{cancelled ? Refusal::Cause::Cancelled : Refusal::Cause::OutOfTime};
  const std::string first = arrangement.things.empty() ? "" : arrangement.things.front().object;
  why.objects = {{first, std::nullopt}};
  why.detail = "arrange";
  if (!cancelled) why.numbers = {{"seconds", seconds}};
  return why;
}

}  // namespace

OperationResult arrange_as_operation(Transaction& transaction, const Arrangement& arrangement,
                                     const SettleOptions& options, const RunContext& context) {
  const Stopwatch stopwatch;
  const ArrangeResult result = arrange(transaction, arrangement, options, context);
  OperationResult out;
  // A conflict becomes a refusal, which programs and people read as that of any operation.
  switch (result.status) {
    case ArrangeResult::Status::Done:
      add_placed(result, out);
      break;
    case ArrangeResult::Status::Conflict:
      out.refuse(refusal_of(*result.conflict, transaction.scene()));
      break;
    case ArrangeResult::Status::Cancelled:
    case ArrangeResult::Status::OutOfTime:
      out.refuse(stopped(result, arrangement, context.time_budget_s));
      out.status = result.status == ArrangeResult::Status::Cancelled
                       ? OperationResult::Status::Cancelled
                       : OperationResult::Status::OutOfTime;
  }
  out.milliseconds = stopwatch.milliseconds();
  return out;
}

}  // namespace trivet
