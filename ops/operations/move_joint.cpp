#include "ops/operations/move_joint.h"

#include <algorithm>
#include <cmath>

#include "core/scene/joint.h"
#include "ops/operations/commit_at_rest.h"
#include "ops/operations/edit_parts.h"
#include "ops/operations/joint_hold.h"
#include "ops/operations/link_move.h"
#include "ops/operations/table.h"
#include "ops/stability/weight.h"

namespace trivet {
namespace {

constexpr Accepts kJointValue{Sort::Number, -kMaxJointValue, kMaxJointValue, "metres or degrees"};
constexpr Accepts kJointLimit{Sort::Word, 0, 0, "", {"lower", "upper"}};

std::optional<InvalidArgument> refuse_goals(const MoveJointOperation& o) {
  if (o.to.has_value() + o.by.has_value() + o.until.has_value() == 1) return std::nullopt;
  return InvalidArgument{o.to   ? "to"
                         : o.by ? "by"
                                : "until",
                         "", "", "accepted: one of \"to\", \"by\" and \"until\""};
}

Refusal no_such_limit(MoveJointOperation::Limit limit) {
  return refused_argument("until", limit == MoveJointOperation::Limit::Upper ? "upper" : "lower",
                          "a limit that the joint has");
}

// The value that is asked for; nothing: the joint has no such limit.
std::optional<double> goal_of(const MoveJointOperation& o, const LinkJoint& joint) {
  if (o.to) return *o.to;
  if (o.by) return joint.value + *o.by;
  const double limit = *o.until == MoveJointOperation::Limit::Upper ? joint.upper : joint.lower;
  return std::isfinite(limit) ? std::optional(limit) : std::nullopt;
}

// Links that bear an object or are it, and those that they hang in.
void add_links_under(const Scene& scene, ObjectId id, std::vector<ObjectId>& out) {
  const auto add = [&](ObjectId link) {
    for (; scene.at(link).joint; link = scene.at(link).joint->parent)
      if (std::find(out.begin(), out.end(), link) == out.end()) out.push_back(link);
  };
  add(id);
  for (const ObjectContact& entry : scene.at(id).contacts)
    if (entry.with.is_object()) add(entry.with.object());
}

}  // namespace

bool gives_way_in_joint(const Scene& scene, ObjectId link) {
  const Object& object = scene.at(link);
  if (!object.joint || !object.joint->friction || !object.placed) return false;
  const JointPlace place = joint_place(*object.joint, object.pose);
  double load = 0;
  for (const ObjectId id : carried_with(scene, link))
    load += joint_load(place, scene.at(id).centre_of_mass(), weight_of(scene.at(id)));
  return moves_joint(place, *object.joint->friction, load);
}

void refuse_links_that_give_way(const Transaction& transaction, const Named& object,
                                OperationResult& result) {
  const Scene& scene = transaction.scene();
  std::vector<ObjectId> links;
  for (const ObjectId id : transaction.touched())
    if (scene.contains(id) && scene.at(id).placed) add_links_under(scene, id, links);
  for (const ObjectId link : links) {
    if (!gives_way_in_joint(scene, link)) continue;
    Refusal why{Refusal::Cause::Topples, {object, named(scene, Support(link))}};
    why.numbers = {{"friction", *scene.at(link).joint->friction}};
    return result.refuse(std::move(why));
  }
}

template <>
const OperationTable& table<MoveJointOperation>() {
  using P = MoveJointOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"move_joint",
        "Open or close a drawer, door or lid with all that lies in and on it, up to a collision or "
        "its limit"}},
      {R("to", &P::to, kJointValue, "Value of the joint to move to"),
       R("by", &P::by, kJointValue, "The same from where it is"),
       R("until", &P::until, kJointLimit, "The same: a limit of the joint")},
      refuse_goals);
  return rows;
}

OperationResult apply(Transaction& transaction, const MoveJointOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  const ObjectId id = id_named(transaction, o.object);
  if (auto why = refuse_joint(scene, scene.at(id))) return refused(std::move(*why));
  const auto goal = goal_of(o, *scene.at(id).joint);
  if (!goal) return refused(no_such_limit(*o.until));
  LinkMove link(scene, id);
  MovePlanner planner(scene, id, o, run);
  if (!planner.refused()) link.drive(planner, *goal);
  OperationResult result =
      commit_at_rest(transaction, planner.finish(ObjectState::Stable), run, named(scene, o.object));
  if (result.ok()) link.keep_value(transaction);
  return result;
}

}  // namespace trivet
