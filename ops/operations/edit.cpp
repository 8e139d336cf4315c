#include "ops/operations/edit.h"

#include <utility>

#include "ops/base/names.h"
#include "ops/operations/commit.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

constexpr double kApart = 1.5;  // clearances between what touched; less than contacts have

using Cause = Refusal::Cause;

std::optional<Refusal> refuse_name(const Scene& scene, const std::string& name) {
  if (!is_object_name(name)) return Refusal{Cause::InvalidName, {{name, std::nullopt}}};
  if (scene.find(name)) return Refusal{Cause::NameTaken, {named(scene, name)}};
  return std::nullopt;
}

OperationResult done() {
  OperationResult result;
  result.end = OperationResult::End::Done;
  return result;
}

ObjectId id_of(const Transaction& transaction, const std::string& name) {
  return *transaction.scene().find(name);
}

Refusal locked(const Scene& scene, ObjectId id) {
  return {Cause::Locked, {named(scene, Support(id))}};
}

// Rates the neighbours that an object has left, and lets them settle if asked to.
void leave(Transaction& transaction, const std::vector<ObjectId>& dependents,
           const MoveOptions& move, const char* op, const Named& object, double clearance,
           OperationRun& run, OperationResult& result) {
  for (const ObjectId id : dependents)
    rate_left_alone(transaction, id, rest_rules(run.options, clearance), result);
  if (!move.settle_left) return;
  settle_unsupported(transaction, run, clearance, {}, result);
  if (run.interrupt.reason()) run.interrupt.refuse(op, object, result);
}

// Takes an object out of the scene, by `remove()`, and sees to those that touched it.
template <class Remove>
OperationResult take_away(Transaction& transaction, ObjectId id, const MoveOptions& move,
                          const char* op, OperationRun& run, const Remove& remove) {
  const Scene& scene = transaction.scene();
  if (scene.at(id).locked) return refused(locked(scene, id));
  const double clearance = clearance_of(scene, run.options);
  const Named name = named(scene, Support(id));
  const std::vector<ObjectId> dependents = dependents_of(scene, id);
  remove();
  OperationResult result = done();
  leave(transaction, dependents, move, op, name, clearance, run, result);
  return result;
}

// Refuses a pose that cannot be committed as it is.
std::optional<Refusal> refuse_stand(const Scene& scene, ObjectId id, const Pose& pose,
                                    const SettleOptions& options) {
  const ClearanceRange range = clearance_range(scene, expected_box(scene, scene.at(id), pose));
  const Placement stands{id, pose};
  if (auto why = refuse_too_coarse(scene, {&stands, 1}, options.clearance)) return why;
  const double clearance = options.clearance > 0 ? options.clearance : range.usual;
  if (auto why = refuse_clearance(clearance, range)) return why;
  auto why = refuse_interpenetration(scene, id, pose, true);
  if (why) why->at = Refusal::At::Given;
  return why;
}

bool is_interpenetration(const Refusal& why) {
  return why.cause == Cause::Crossing || why.cause == Cause::Float32Contact ||
         why.cause == Cause::BelowFloor || why.cause == Cause::Float32BelowFloor;
}

// The pose of an object that only touches others there, as flush walls do, moved apart from them:
// kApart clearances along one axis of the world, two or all three.
std::optional<Pose> moved_apart(const Scene& scene, ObjectId id, const Pose& pose,
                                double clearance) {
  for (int num_axes = 1; num_axes <= 3; ++num_axes)
    for (int code = 0; code < 27; ++code) {
      const Vec3 way(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if (way.squaredNorm() != num_axes) continue;
      Pose apart = pose;
      apart.translation += kApart * clearance * way;
      if (!refuse_interpenetration(scene, id, apart, true)) return apart;
    }
  return std::nullopt;
}

void stand_at(Transaction& transaction, ObjectId id, const Pose& pose, const RestRules& rules) {
  const Object& object = transaction.scene().at(id);
  const Neighbourhood others(transaction.scene(), id);
  ObjectState state = ObjectState::Fixed;
  if (!object.fixed) state = state_at(object, pose, others, rules);
  commit_object(transaction, id, pose, state,
                touching(body_of(object, pose), others, rules.clearance), rules);
}

}  // namespace

OperationResult apply(Transaction& transaction, const AppendOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.object)) return refused(std::move(*why));
  if (!o.shape) {
    Refusal why{Cause::ModelNotLoaded, {{o.object, std::nullopt}}};
    why.detail = o.model;
    return refused(std::move(why));
  }
  Object object;
  object.name = o.object;
  object.model = o.model_data;
  object.shape = o.shape;
  object.up = o.up.value_or(object.model ? object.model->up : UpAxis::Z);
  object.scale = o.scale;
  object.fixed = o.fixed;
  if (o.material) object.material = *o.material;
  transaction.add(std::move(object));
  return done();
}

OperationResult apply(Transaction& transaction, const DuplicateOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.as)) return refused(std::move(*why));
  const Object& original = transaction.scene().at(id_of(transaction, o.object));
  Object object;
  object.name = o.as;
  object.model = original.model;
  object.shape = original.shape;
  object.up = original.up;
  object.scale = original.scale;
  object.material = original.material;
  transaction.add(std::move(object));
  return done();
}

OperationResult apply(Transaction& transaction, const RenameOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.to)) return refused(std::move(*why));
  transaction.edit(id_of(transaction, o.object), [&](Object& object) { object.name = o.to; });
  return done();
}

OperationResult apply(Transaction& transaction, const DeleteOperation& o, OperationRun& run) {
  const ObjectId id = id_of(transaction, o.object);
  return take_away(transaction, id, o, "delete", run, [&] { transaction.remove(id); });
}

OperationResult apply(Transaction& transaction, const UnplaceOperation& o, OperationRun& run) {
  const ObjectId id = id_of(transaction, o.object);
  const Object& here = transaction.scene().at(id);
  if (!here.placed && !here.locked)
    return refused({Cause::NotPlaced, {named(transaction.scene(), Support(id))}});
  return take_away(transaction, id, o, "unplace", run, [&] {
    transaction.clear_contacts(id);
    transaction.edit(id, [](Object& object) {
      object.placed = false;
      object.pose = {};
      object.state = ObjectState::Unplaced;
      object.stability_margin = object.least_friction = 0;
    });
  });
}

OperationResult apply(Transaction& transaction, const LockOperation& o, OperationRun&) {
  transaction.edit(id_of(transaction, o.object), [&](Object& object) { object.locked = o.locked; });
  return done();
}

OperationResult apply(Transaction& transaction, const FixOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_of(transaction, o.object);
  if (scene.at(id).fixed == o.fixed) return done();
  transaction.edit(id, [&](Object& object) { object.fixed = o.fixed; });
  if (!scene.at(id).placed) return done();
  const double clearance = clearance_of(scene, run.options);
  if (o.fixed) {
    if (auto why = refuse_stand(scene, id, scene.at(id).pose, run.options))
      return refused(std::move(*why));
    stand_at(transaction, id, scene.at(id).pose, rest_rules(run.options, clearance));
    return done();
  }
  OperationResult result = done();
  transaction.edit(id, [](Object& object) { object.state = ObjectState::Stable; });
  rate_left_alone(transaction, id, rest_rules(run.options, clearance), result);
  return result;
}

// Nothing moves; the object and what it touches are rated again.
OperationResult apply(Transaction& transaction, const MaterialOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_of(transaction, o.object);
  transaction.edit(id, [&](Object& object) { object.material = o.material; });
  OperationResult result = done();
  // No rest depends on it by these rules; what others have judged stays.
  if (!has_finite_friction(run.options)) return result;
  const RestRules rules = rest_rules(run.options, clearance_of(scene, run.options));
  std::vector<ObjectId> touched{id};
  for (const ObjectContact& entry : scene.at(id).contacts)
    if (entry.with.is_object()) touched.push_back(entry.with.object());
  for (const ObjectId other : touched) {
    const ObjectState state = scene.at(other).state;
    if (state == ObjectState::Stable || state == ObjectState::Unsupported)
      rate_left_alone(transaction, other, rules, result);
  }
  return result;
}

OperationResult apply(Transaction& transaction, const GroupOperation& o, OperationRun&) {
  transaction.edit(id_of(transaction, o.object), [&](Object& object) { object.group = o.group; });
  return done();
}

OperationResult apply(Transaction& transaction, const StandOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_of(transaction, o.object);
  const Object& object = scene.at(id);
  const bool was_placed = object.placed;
  if (object.locked) return refused(locked(scene, id));
  if (object.fixed && was_placed) return refused({Cause::Fixed, {named(scene, Support(id))}});
  const double clearance = clearance_of(scene, run.options, expected_box(scene, object, o.pose));
  Pose pose = o.pose;
  if (auto why = refuse_stand(scene, id, pose, run.options)) {
    std::optional<Pose> apart;
    if (is_interpenetration(*why)) apart = moved_apart(scene, id, pose, clearance);
    if (!apart) return refused(std::move(*why));
    pose = *apart;
  }
  std::vector<ObjectId> dependents;
  if (was_placed) dependents = dependents_of(scene, id);
  stand_at(transaction, id, pose, rest_rules(run.options, clearance));
  OperationResult result = done();
  result.moved = (pose.translation - o.pose.translation).norm();
  leave(transaction, dependents, o, "stand", named(scene, Support(id)), clearance, run, result);
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

}  // namespace trivet
