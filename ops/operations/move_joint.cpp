#include "ops/operations/move_joint.h"

#include <algorithm>
#include <cmath>

#include "core/scene/joint.h"
#include "ops/operations/commit_at_rest.h"
#include "ops/operations/edit_parts.h"
#include "ops/operations/joint_drive.h"
#include "ops/operations/joint_hold.h"
#include "ops/operations/table.h"
#include "ops/stability/stability.h"

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

Refusal invalid(const char* key, const std::string& value, Sentence accepted) {
  Refusal out{Refusal::Cause::InvalidArgument};
  out.detail = in_words({key, value, std::move(accepted)});
  return out;
}

std::string hanging_in_joints(const Scene& scene) {
  std::string out;
  for (const ObjectId id : scene.ids())
    if (scene.at(id).joint) out += (out.empty() ? "\"" : ", \"") + scene.at(id).name + "\"";
  return out;
}

// Questions of move() to the scene.
std::optional<Refusal> refuse_joint(const Scene& scene, const Object& object) {
  const std::string value = "\"" + object.name + "\"";
  if (!object.joint) {
    const std::string known = hanging_in_joints(scene);
    return invalid("object", value,
                   known.empty() ? Sentence("an object that hangs in a joint: there is none")
                                 : say("an object that hangs in a joint: %1", known));
  }
  const Object& parent = scene.at(object.joint->parent);
  for (const Object* const o : {&object, &parent})
    if (!o->placed)
      return Refusal{Refusal::Cause::NotPlaced, {named(scene, Support(*scene.find(o->name)))}};
  return std::nullopt;
}

// The value that is asked for; nothing: the joint has no such limit.
std::optional<double> goal_of(const MoveJointOperation& o, const LinkJoint& joint) {
  if (o.to) return *o.to;
  if (o.by) return joint.value + *o.by;
  const double limit = *o.until == MoveJointOperation::Limit::Upper ? joint.upper : joint.lower;
  return std::isfinite(limit) ? std::optional(limit) : std::nullopt;
}

JointToMove joint_to_move(const Scene& scene, ObjectId id) {
  const LinkJoint& joint = *scene.at(id).joint;
  const Pose here = link_pose(joint, scene.at(joint.parent).pose, joint.value);
  JointToMove out;
  static_cast<JointPlace&>(out) = joint_place(joint, here);
  out.name = scene.at(id).name;
  out.links = driven_with(scene, id);
  return out;
}

// Links go to the poses that follow from the values alone: what is opened and closed again is where
// it was, to the bit.
void correct_links(const Scene& scene, double value, MovingGroup& group) {
  const ObjectId moved = group.ids()[0];
  const LinkJoint& joint = *group.object().joint;
  group.correct(0, link_pose(joint, scene.at(joint.parent).pose, value));
  const auto member = [&](ObjectId id) {
    return std::find(group.ids().begin(), group.ids().end(), id) - group.ids().begin();
  };
  for (const ObjectId id : links_below(scene, moved)) {
    const LinkJoint& below = *scene.at(id).joint;
    const Pose parent = group.pose(static_cast<Index>(member(below.parent)));
    if (scene.at(id).placed)
      group.correct(static_cast<Index>(member(id)), link_pose(below, parent, below.value));
  }
}

// @param end  of the move. @return metres or degrees.
MovePlan planned(MovePlanner& planner, const JointToMove& joint, double goal, double& value) {
  const SettleStep::Kind kind = joint.turns ? SettleStep::Kind::Turn : SettleStep::Kind::Move;
  const JointMove end = drive_joint(planner.group(), joint, goal, [&] { planner.note_step(kind); });
  value = end.value;
  OperationResult& result = planner.result();
  result.end = end.end == JointMove::End::Limit ? OperationResult::End::Limit
                                                : OperationResult::End::Reached;
  if (end.end == JointMove::End::Blocked) planner.note_blocked(end.blocker, end.point);
  if (joint.turns) result.turned_deg = value - joint.value;
  result.joint_value = value;
  if (value != joint.value) correct_links(planner.scene(), value, planner.group());
  return planner.finish(ObjectState::Stable);
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
  if (!goal)
    return refused(invalid("until",
                           *o.until == MoveJointOperation::Limit::Upper ? "upper" : "lower",
                           "a limit that the joint has"));
  const JointToMove joint = joint_to_move(scene, id);
  MovePlanner planner(scene, id, o, run);
  double value = joint.value;
  MovePlan plan = planner.refused() ? planner.finish(ObjectState::Stable)
                                    : planned(planner, joint, *goal, value);
  OperationResult result =
      commit_at_rest(transaction, std::move(plan), run, named(scene, o.object));
  if (!result.ok()) return result;
  auto moved = std::make_shared<LinkJoint>(*scene.at(id).joint);
  moved->value = value;
  transaction.edit(id, [&](Object& object) { object.joint = std::move(moved); });
  return result;
}

}  // namespace trivet
