// Requests of a dialogue that move many objects, or judge: mend, settle, move_joint, check, joints.
#include "core/base/quoted.h"
#include "core/contact/contact_memory.h"
#include "core/io/json.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/files/foreign/own_joints.h"
#include "ops/files/foreign/repair_json.h"
#include "ops/files/report/repaired.h"
#include "ops/mend/mend.h"
#include "ops/session/dialogue.h"
#include "ops/session/others.h"

namespace trivet {
namespace {

constexpr double kLongestRepair = 1e6;  // seconds

MendOptions repair_options(const JsonPlace& how, const char* only_key, double& only_value,
                           double most) {
  MendOptions out;
  if (how.value() == true) return out;
  how.expect_object({}, {"only", "seconds", only_key});
  if (const auto value = how.find(only_key)) only_value = value->number(0, most);
  if (const auto seconds = how.find("seconds")) out.seconds = seconds->number(0, kLongestRepair);
  if (const auto only = how.find("only"))
    for (const JsonPlace& name : only->items()) out.only.push_back(name.text());
  return out;
}

RecordedPoses poses_of(const Scene& scene, const SettledScene& settled) {
  RecordedPoses out;
  for (const SettledObject& o : settled.moved)
    out.push_back({scene.at(o.id).name, std::optional(o.to)});
  return out;
}

double goal_of(const JsonPlace& request, const SceneJoint& joint) {
  const auto to = request.find("to"), by = request.find("by");
  if (to.has_value() == by.has_value()) request.refuse("\"to\" or \"by\"");
  if (by) return joint.value + by->number(-kMaxJointValue, kMaxJointValue);
  if (to->value() == "lower" || to->value() == "upper")
    return limit_of(joint, to->value() == "upper");
  if (!to->value().is_number()) to->refuse("a number, \"lower\", \"upper\"");
  return to->number(-kMaxJointValue, kMaxJointValue);
}

}  // namespace

SceneVerdict Dialogue::verdict() const {
  RunOptions options;
  options.settle = m_options.settle;
  options.context = m_options.context;
  options.topples_alone = true;
  options.verdict_seconds = m_options.context.time_budget_s;
  LayoutRun run;
  run.scene = m_session.scene();
  run.settle = options.settle;
  run.largest_clearance = m_session.largest_clearance();
  finish_run(options, run);
  SceneVerdict out = verdict_of(run, 0);
  out.path = m_opened.start_file;
  out.format = "Trivet";
  if (m_opened.others) {
    const OpenedScene& opened = m_opened.others->opened();
    out.format = opened.format, out.key = opened.key, out.num_joints = opened.num_joints;
    out.notes = opened.notes;
    out.unread.insert(out.unread.begin(), opened.unread.begin(), opened.unread.end());
    add_what_joints_bear(opened, joints(), options, run, out);
  }
  return out;
}

OrderedJson Dialogue::check() const {
  OrderedJson out = state();
  out.update(OrderedJson::parse(verdict_json(verdict())));
  return out;
}

std::vector<SceneJoint> Dialogue::joints() const {
  return m_opened.others ? m_opened.others->joints(m_session.num_done())
                         : joints_in(m_session.scene());
}

OrderedJson Dialogue::joint_list() const {
  OrderedJson out = state();
  out["joints"] = OrderedJson::array();
  for (const SceneJoint& joint : joints())
    out["joints"].push_back(joint_json(m_session.scene(), joint));
  return out;
}

OrderedJson Dialogue::repaired(const char* step, const SettledScene& repaired,
                               const OrderedJson& told) {
  if (m_options.context.cancel && *m_options.context.cancel)
    return {{"status", "cancelled"}, {"reason", std::string(step) + " was cancelled"}};
  if (!repaired.moved.empty())
    m_session.place(step, poses_of(m_session.scene(), repaired), m_options.settle);
  OrderedJson out = state();
  out.update(told);
  return out;
}

OrderedJson Dialogue::mend(const JsonPlace& how) {
  double tolerance = 0;
  MendOptions options = repair_options(how, "tolerance", tolerance, 1);
  options.tolerance = tolerance;
  begin(options);
  const ContactMemory contacts;  // the step that is kept asks for what mending found
  Scene scene = m_session.scene();
  const MendedScene mended = mend_scene(scene, options);
  return repaired("mend", mended, mended_json(mended));
}

OrderedJson Dialogue::settle(const JsonPlace& how) {
  double lift = MendOptions().most_lift;
  MendOptions options = repair_options(how, "lift", lift, 1);
  options.most_lift = lift;
  begin(options);
  const ContactMemory contacts;
  Scene scene = m_session.scene();
  const SettledScene settled = settle_scene(scene, options);
  return repaired("settle", settled, settled_json(settled));
}

void Dialogue::begin(MendOptions& options) const {
  options.settle = m_options.settle;
  options.context = m_options.context;
  const double budget = m_options.context.time_budget_s;
  if (budget > 0 && !(options.seconds > 0 && options.seconds < budget)) options.seconds = budget;
}

OrderedJson Dialogue::move_joint(const JsonPlace& request) {
  request.expect_object({"move_joint"}, {"to", "by"});
  const JsonPlace name = request.at("move_joint");
  std::string known;
  const SceneJoint* found = nullptr;
  const std::vector<SceneJoint> all = joints();
  for (const SceneJoint& joint : all) {
    if (joint.name == name.text()) found = &joint;
    known += (known.empty() ? "" : ", ") + quoted(joint.name);
  }
  if (!found)
    name.refuse(known.empty() ? Sentence("none: the scene has no slides and hinges")
                              : Sentence(known));
  if (!found->held.empty())
    return {{"status", "refused"}, {"reason", in_english(held_joint(*found))}};
  const double goal = goal_of(request, *found);
  if (!m_opened.others) return move_own_joint(name.text(), goal);
  const JointMove move = m_opened.others->move(m_session, name.text(), goal,
                                               OperationRun(m_options.settle, m_options.context));
  OrderedJson out = state();
  for (const SceneJoint& joint : joints())
    if (joint.name == name.text()) out.update(joint_move_json(m_session.scene(), 0, joint, move));
  return out;
}

// An operation as any other; its answer has the same keys as that of other programs' joints.
OrderedJson Dialogue::move_own_joint(const std::string& link, double goal) {
  MoveJointOperation operation;
  operation.object = link, operation.to = goal;
  OrderedJson out = perform({operation});
  if (out["status"] != "ok") return out;
  for (const SceneJoint& joint : joints())
    if (joint.name == link) out.update(joint_json(m_session.scene(), joint));
  out["end"] = out["ended"];
  if (!out.contains("carried")) out["carried"] = OrderedJson::array();
  return out;
}

}  // namespace trivet
