#include "ops/operations/edit_parts.h"

#include <utility>

#include "core/scene/joint.h"
#include "ops/base/names.h"
#include "ops/operations/commit.h"
#include "ops/settle/rest.h"

namespace trivet {

std::optional<Refusal> refuse_name(const Scene& scene, const std::string& name) {
  if (!is_object_name(name)) return Refusal{Refusal::Cause::InvalidName, {{name, std::nullopt}}};
  if (scene.find(name)) return Refusal{Refusal::Cause::NameTaken, {named(scene, name)}};
  return std::nullopt;
}

std::optional<Refusal> refuse_in_joint(const Scene& scene, ObjectId id) {
  const Object& object = scene.at(id);
  if (!object.joint && object.links.empty()) return std::nullopt;
  const Object& link = object.joint ? object : scene.at(object.links[0]);
  Refusal out{Refusal::Cause::InvalidArgument};
  out.detail = say("\"%1\" hangs in \"%2\" by a joint; accepted: objects without joints", link.name,
                   scene.at(link.joint->parent).name);
  return out;
}

OperationResult done_result() {
  OperationResult result;
  result.end = OperationResult::End::Done;
  return result;
}

ObjectId id_named(const Transaction& transaction, const std::string& name) {
  return *transaction.scene().find(name);
}

Refusal locked_refusal(const Scene& scene, ObjectId id) {
  return {Refusal::Cause::Locked, {named(scene, Support(id))}};
}

void leave_neighbours(Transaction& transaction, const std::vector<ObjectId>& dependents,
                      const MoveOptions& move, const char* op, const Named& object,
                      double clearance, OperationRun& run, OperationResult& result) {
  for (const ObjectId id : dependents)
    rate_left_alone(transaction, id, rest_rules(run.options, clearance), result);
  if (!move.settle_left) return;
  settle_unsupported(transaction, run, clearance, {}, result);
  if (run.interrupt.reason()) run.interrupt.refuse(op, object, result);
}

std::optional<Refusal> refuse_stand(const Scene& scene, ObjectId id, const Pose& pose,
                                    const SettleOptions& options) {
  const PlacedBox expected{id, expected_box(scene, scene.at(id), pose)};
  const ClearanceRange range = clearance_range_near(scene, expected.box, {&expected, 1});
  // Checks go from size to clearance to the exact test, so that the first cause is told.
  const Placement stands{id, pose};
  if (auto why = refuse_too_coarse(scene, {&stands, 1}, options.clearance)) return why;
  const double clearance = options.clearance > 0 ? options.clearance : range.usual;
  if (auto why = refuse_clearance(clearance, range)) return why;
  auto why = refuse_interpenetration(scene, id, pose, true);
  if (why) why->at = Refusal::At::Given;
  return why;
}

void stand_at(Transaction& transaction, ObjectId id, const Pose& pose, const RestRules& rules) {
  const Object& object = transaction.scene().at(id);
  const Neighbourhood others(transaction.scene(), id);
  ObjectState state = ObjectState::Fixed;
  if (!object.fixed) state = state_at(object, pose, others, rules);
  commit_object(transaction, id, pose, state,
                touching(body_of(object, pose), others, rules.clearance), rules);
}

}  // namespace trivet
