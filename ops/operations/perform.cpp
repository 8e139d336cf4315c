#include "ops/operations/perform.h"

#include <utility>

#include "core/base/arena.h"
#include "core/contact/contact_memory.h"
#include "ops/detect/detector.h"
#include "ops/free_places/place_region.h"
#include "ops/operations/carried_drapes.h"
#include "ops/operations/commit.h"
#include "ops/operations/commit_at_rest.h"
#include "ops/operations/draped_rest.h"
#include "ops/operations/joint_hold.h"
#include "ops/operations/put_parts.h"
#include "ops/operations/tries.h"
#include "ops/operations/validate.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"
#include "ops/settle/program_memory.h"

namespace trivet {
namespace {

/// Operations that move objects are planned, then committed; edits are applied as they are.
template <class Move>
concept Plannable = requires(const Scene& scene, ObjectId id, const Move& o, OperationRun& run) {
  { plan(scene, id, o, run) } -> std::same_as<MovePlan>;
};

/// Edits that may take away what something rests on. Where an object stands is given.
template <class Any>
bool unbalances(const Any&) {
  return std::is_same_v<Any, DeleteOperation> || std::is_same_v<Any, UnplaceOperation>;
}
bool unbalances(const FixOperation& o) { return !o.fixed; }

/// First contacts by which the whole may come to rest: fewer than for what is there already, as it
/// costs less to put something elsewhere. With 300, bins of ten hold 1 to 2 %, heaps of 30 3 %
/// more.
constexpr Budget kBudgetOfPut{120};
/// The same where other starts may be tried: a joint motion of many costs more than some of them.
constexpr Budget kBudgetOfFirstStart{120, 4};
/// The same at the places that a PUT tries, all together.
constexpr Budget kBudgetOfTrials{2400};

// An object that came to rest may still stand badly, by is_judged_at_rest().
std::optional<Refusal> refuse_to_stand(const Scene& scene, ObjectId id, const PlaceOptions& place) {
  const Object& object = scene.at(id);
  const Named name = named(scene, Support(id));
  // The object may have moved since its place was judged: it came to rest meanwhile.
  if (!PlaceRegion(place.region).holds(body_of(object)))
    return Refusal{Refusal::Cause::LeavesRegion, {name}};
  if (object.stability_margin < place.least_margin)
    return Refusal{Refusal::Cause::StandsBadly,
                   {name},
                   {{"margin", object.stability_margin}, {"least_margin", place.least_margin}}};
  if (object.least_friction > place.most_friction)
    return Refusal{Refusal::Cause::StandsBadly,
                   {name},
                   {{"friction", object.least_friction}, {"most_friction", place.most_friction}}};
  return std::nullopt;
}

/// Copies of larger scenes cost more than trials: about 1 µs an object.
constexpr size_t kMostObjectsToCopy = 2000;

int threads_of_put(const Scene& scene, const OperationRun& run) {
  // A stage that was asked for by name answers all queries, one at a time.
  const bool is_bound = run.detector && !run.detector->may_ask_bvhs();
  return is_bound || scene.num_objects() > kMostObjectsToCopy ? 1 : num_threads_here();
}

/// A PUT takes a place only where its commit would be accepted.
OperationResult perform_put(Transaction& transaction, ObjectId id, const PutOperation& o,
                            OperationRun& run, const Named& name) {
  // The verdict at a place is that of a trial commit with all that follows from it.
  const bool is_judged = o.place && is_judged_at_rest(*o.place);
  Budget trials = kBudgetOfTrials;
  const auto refuse_place = [&](const MovePlan& plan) {
    Transaction trial(transaction);  // taken back
    const double clearance = plan.group ? plan.group->clearance() : 0;
    const CommitVerdict verdict = try_commit(trial, plan, run, name, kBudgetOfPut.within(trials));
    // All places together share one budget of work.
    trials.first_contacts -= verdict.first_contacts;
    if (!is_judged || verdict.refusal) return verdict.refusal;
    rate_again(trial, {id}, rest_rules(run.options, clearance));
    return refuse_to_stand(trial.scene(), id, *o.place);
  };
  TryCommit try_commit_there;
  if (is_judged || keeps_whole_at_rest(run.options)) try_commit_there = refuse_place;
  const PutSteps put{[&](const Scene& scene, const PutOperation& move, OperationRun& own) {
                       return plan_put(scene, id, move, own, try_commit_there);
                     },
                     [&](Transaction& inner, MovePlan plan, Budget budget, OperationRun& own) {
                       return commit_at_rest(inner, std::move(plan), own, name, budget);
                     },
                     threads_of_put(transaction.scene(), run)};
  // A start that was asked for exactly, or a place that is searched for, has no other tries.
  const bool is_exact = o.tries == 1 || o.place || run.options.literal_paper_rules;
  if (is_exact)
    return put.commit(transaction, put.plan(transaction.scene(), o, run), kBudgetOfPut, run);
  OperationResult result = put_by_tries(transaction, id, o, put, kBudgetOfFirstStart, run);
  // A refusal is that of the first start, but its time is that of all.
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

template <class Any>
OperationResult perform_one(Transaction& transaction, ObjectId id, const Any& o, OperationRun& run,
                            const RunContext& context) {
  // Each kind of operation has a plan to commit, or edits the scene itself.
  const Named name = named(transaction.scene(), o.object);
  if constexpr (std::is_same_v<Any, ArrangeOperation>) {
    return o.problem->solve(transaction, run.options, context);
  } else if constexpr (std::is_same_v<Any, RepairOperation>) {
    return repair(transaction, o, run.options, context);
  } else if constexpr (Plannable<Any>) {
    const ContactMemory memory;  // what was tried is committed; what stays is judged again
    const ProgramMemory programs;
    if constexpr (std::is_same_v<Any, PutOperation>)
      return perform_put(transaction, id, o, run, name);
    else
      return commit_at_rest(transaction, plan(transaction.scene(), id, o, run), run, name);
  } else {
    const Scene& scene = transaction.scene();
    // The place is noted before the edit, as the object may be gone afterwards.
    const Aabb place = scene.contains(id) ? scene.world_box(id) : Aabb{};
    OperationResult result = apply(transaction, o, run);
    if (!result.ok()) return result;
    const double clearance = clearance_near(scene, run.options, place);
    // Edits that take away support let the whole give way.
    if (keeps_whole_at_rest(run.options) && unbalances(o))
      settle_whole(transaction, name, clearance, run, result);
    if (result.ok())
      rate_again(transaction, transaction.touched(), rest_rules(run.options, clearance));
    return result;
  }
}

template <class Any>
bool moves_its_object(const Any&) {
  return Plannable<Any> || std::is_same_v<Any, StandOperation>;
}

std::optional<ObjectId> moved_by(const Operation& operation, std::optional<ObjectId> object) {
  const bool moves = std::visit([](const auto& o) { return moves_its_object(o); }, operation);
  return moves ? object : std::nullopt;
}

// Adds the depth to refusals of poses that a user gave; ours are tried by the hundreds.
void tell_depth(const Scene& scene, std::optional<ObjectId> id, const Operation& operation,
                OperationResult& result) {
  if (!id || !result.refusal) return;
  Refusal& why = *result.refusal;
  // Refusals by the exact tests of a pose have a depth, others have none.
  const bool is_exact_test =
      why.cause == Refusal::Cause::Crossing || why.cause == Refusal::Cause::Inside ||
      why.cause == Refusal::Cause::Float32Contact || why.cause == Refusal::Cause::BelowFloor ||
      why.cause == Refusal::Cause::Float32BelowFloor;
  // At the end of a motion the pose is not the user's.
  if (!is_exact_test || why.at == Refusal::At::End) return;
  Pose pose = scene.at(*id).pose;
  const auto* const put = std::get_if<PutOperation>(&operation);
  // A PUT that searches its place has no pose of the user's.
  if (put && put->place) return;
  if (put) pose = put->start;
  if (const auto* const stand = std::get_if<StandOperation>(&operation)) pose = stand->pose;
  add_depth(scene, {*id, pose}, why);
}

}  // namespace

OperationResult perform(Transaction& outer, const Operation& operation,
                        const SettleOptions& options, const RunContext& context) {
  // Arguments are checked before the scene is looked at.
  if (auto why = validate(operation)) return refused(std::move(*why));
  const std::string& name = object_name(operation);
  const std::optional<ObjectId> object = outer.scene().find(name);
  const bool names_one = !std::holds_alternative<AppendOperation>(operation) &&
                         !std::holds_alternative<ArrangeOperation>(operation) &&
                         !std::holds_alternative<RepairOperation>(operation) &&
                         !std::holds_alternative<DrapeOperation>(operation);
  if (!object && names_one) return refused(unknown_object(outer.scene(), name));
  OperationRun run(options, context);
  // Everything happens in one transaction, which a refusal takes back.
  Transaction inner(outer);
  const CarriedDrapes carried(inner, moved_by(operation, object));
  OperationResult result = std::visit(
      [&](const auto& o) {
        return perform_one(inner, object.value_or(ObjectId{}), o, run, context);
      },
      operation);
  if (result.ok()) carried.follow(inner, run, result);
  // A change of material is told, not refused.
  if (result.ok() && keeps_whole_at_rest(options) &&
      !std::holds_alternative<MaterialOperation>(operation))
    refuse_links_that_give_way(inner, named(inner.scene(), name), result);
  // Supports that a hand holds, or that are unsupported or invalid, are named: the result stands on
  // them.
  if (result.ok() && object && inner.scene().contains(*object))
    for (const ObjectId id : unsound_supports(inner.scene(), *object))
      result.unsound.push_back(inner.scene().at(id).name);
  if (result.ok()) {
    name_disturbed(inner.scene(), inner.touched(), result);
    inner.commit();
  } else {
    tell_depth(inner.scene(), object, operation, result);
  }
  return result;
}

OperationResult perform(Scene& scene, const Operation& operation, const SettleOptions& options,
                        const RunContext& context) {
  Transaction transaction(scene);
  OperationResult result = perform(transaction, operation, options, context);
  if (result.ok()) transaction.commit();
  return result;
}

OperationResult put(Scene& scene, ObjectId id, const Pose& start, const SettleOptions& options,
                    const RunContext& context) {
  return perform(scene, PutOperation{{scene.at(id).name}, start, {}}, options, context);
}

OperationResult stand(Scene& scene, ObjectId id, const Pose& pose, const SettleOptions& options) {
  return perform(scene, StandOperation{{scene.at(id).name}, pose}, options);
}

}  // namespace trivet
