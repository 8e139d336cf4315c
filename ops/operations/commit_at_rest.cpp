#include "ops/operations/commit_at_rest.h"

#include <utility>

#include "ops/operations/commit.h"

namespace trivet {
namespace {

// An object that settling called wedged may have come to rest since; otherwise that is the refusal.
void refuse_wedged(Transaction& transaction, Refusal wedged, const RestRules& rules,
                   OperationResult& result) {
  const Scene& scene = transaction.scene();
  const ObjectId id = *scene.find(wedged.objects.front().name);
  rate_left_alone(transaction, id, rules, result);
  if (scene.at(id).state != ObjectState::Stable) result.refuse(std::move(wedged));
}

/// A commit in which the whole comes to rest.
struct WholeCommit {
  OperationResult result;
  Budget left;
};

WholeCommit commit_whole(Transaction& transaction, MovePlan plan, OperationRun& run,
                         const Named& object, Budget budget, Purpose purpose) {
  const double clearance = plan.group ? plan.group->clearance() : 0;
  const char* const op = plan.op;
  // The whole is judged after the commit, in the same transaction.
  const bool settles = keeps_whole_at_rest(run.options) && plan.changes_scene && !plan.is_free;
  std::optional<Refusal> wedged = std::move(plan.wedged);
  std::vector<ObjectId> in_hand;
  // An object in hand is held, unless it was released.
  if (settles && plan.otherwise == ObjectState::Held && !plan.settled)
    in_hand = plan.group->driven();
  WholeCommit out{commit(transaction, std::move(plan), run), budget};
  if (settles && out.result.ok()) {
    out.left = settle_whole(transaction, object, clearance, run, out.result, budget, purpose,
                            std::move(in_hand));
    if (run.interrupt.reason()) run.interrupt.refuse(op, object, out.result);
    // The wedged object had its chance to come to rest.
    if (wedged && out.result.ok())
      refuse_wedged(transaction, std::move(*wedged), rest_rules(run.options, clearance),
                    out.result);
  }
  return out;
}

}  // namespace

OperationResult commit_at_rest(Transaction& transaction, MovePlan plan, OperationRun& run,
                               const Named& object, Budget budget) {
  const double clearance = plan.group ? plan.group->clearance() : 0;
  const bool changes = plan.changes_scene;
  OperationResult result =
      commit_whole(transaction, std::move(plan), run, object, budget, Purpose::Commit).result;
  if (changes && result.ok())
    rate_again(transaction, transaction.touched(), rest_rules(run.options, clearance));
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

CommitVerdict try_commit(Transaction& trial, MovePlan plan, OperationRun& run, const Named& object,
                         Budget budget) {
  WholeCommit tried = commit_whole(trial, std::move(plan), run, object, budget, Purpose::Trial);
  return {std::move(tried.result.refusal), budget.first_contacts - tried.left.first_contacts};
}

}  // namespace trivet
