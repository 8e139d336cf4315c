#include "ops/operations/link_move.h"

#include <algorithm>

#include "core/scene/joint.h"
#include "core/scene/transaction.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

std::string hanging_in_joints(const Scene& scene) {
  std::string out;
  for (const ObjectId id : scene.ids())
    if (scene.at(id).joint) out += (out.empty() ? "\"" : ", \"") + scene.at(id).name + "\"";
  return out;
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

}  // namespace

Refusal refused_argument(const char* key, const std::string& value, Sentence accepted) {
  Refusal out{Refusal::Cause::InvalidArgument};
  out.detail = in_words({key, value, std::move(accepted)});
  return out;
}

std::optional<Refusal> refuse_joint(const Scene& scene, const Object& object) {
  if (!object.joint) {
    const std::string known = hanging_in_joints(scene);
    return refused_argument("object", "\"" + object.name + "\"",
                            known.empty()
                                ? Sentence("an object that hangs in a joint: there is none")
                                : say("an object that hangs in a joint: %1", known));
  }
  const Object& parent = scene.at(object.joint->parent);
  for (const Object* const o : {&object, &parent})
    if (!o->placed)
      return Refusal{Refusal::Cause::NotPlaced, {named(scene, Support(*scene.find(o->name)))}};
  return std::nullopt;
}

LinkMove::LinkMove(const Scene& scene, ObjectId link)
    : m_link(link), m_joint(joint_to_move(scene, link)), m_value(m_joint.value) {}

void LinkMove::drive(MovePlanner& planner, double goal) {
  const SettleStep::Kind kind = m_joint.turns ? SettleStep::Kind::Turn : SettleStep::Kind::Move;
  const JointMove end =
      drive_joint(planner.group(), m_joint, goal, [&] { planner.note_step(kind); });
  m_value = end.value;
  OperationResult& result = planner.result();
  result.end = end.end == JointMove::End::Limit ? OperationResult::End::Limit
                                                : OperationResult::End::Reached;
  if (end.end == JointMove::End::Blocked) planner.note_blocked(end.blocker, end.point);
  if (m_joint.turns) result.turned_deg = m_value - m_joint.value;
  result.joint_value = m_value;
  if (m_value != m_joint.value) correct_links(planner.scene(), m_value, planner.group());
}

void LinkMove::keep_value(Transaction& transaction) const {
  auto moved = std::make_shared<LinkJoint>(*transaction.scene().at(m_link).joint);
  moved->value = m_value;
  transaction.edit(m_link, [&](Object& object) { object.joint = std::move(moved); });
}

}  // namespace trivet
