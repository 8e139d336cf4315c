#include "ops/session/others.h"

#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/motion/compose.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/files/layout/paths.h"
#include "ops/session/restore.h"

namespace trivet {
namespace {

ModelSource no_models() {
  return [](const std::string& name, const Tessellation&) -> Model {
    bad_input("\"%1\" cannot come into a scene of another program", name);
  };
}

}  // namespace

OthersScene::OthersScene(OpenedScene opened)
    : m_opened(std::move(opened)), m_first(m_opened.judged.scene) {
  m_joints[0] = m_opened.joints;
}

const std::vector<SceneJoint>& OthersScene::joints(size_t num_done) const {
  // Joints are those of the last step that moved one.
  return std::prev(m_joints.upper_bound(num_done))->second;
}

void OthersScene::forget_from(size_t num_done) {
  if (num_done > 0) m_joints.erase(m_joints.lower_bound(num_done), m_joints.end());
}

JointMove OthersScene::move(Session& session, const std::string& name, double to,
                            const OperationRun& run) {
  // The move is computed on a copy of the session's scene, and becomes one of its steps.
  m_opened.judged.scene = session.scene();
  m_opened.joints = joints(session.num_done());
  SceneJoint& joint = joint_named(m_opened, name);
  const double before = joint.value;
  NewPoses poses;
  JointMove out = move_joint_of(m_opened, joint, to, run, poses);
  // A joint that did not move is no step.
  if (out.value == before) return out;
  RecordedPoses recorded;
  for (const auto& [id, pose] : poses)
    recorded.push_back({session.scene().at(id).name, std::optional(pose)});
  session.place("move \"" + name + "\"", recorded, run.options);
  // Values belong to the number of steps, so that undo brings the old ones back.
  m_joints[session.num_done()] = m_opened.joints;
  return out;
}

void OthersScene::write(const Session& session, const std::string& path) const {
  const std::string extension = lower_extension(m_opened.path);
  if (lower_extension(path) != extension)
    bad_file(path, "cannot be saved; accepted: a file name ending in %1, as the scene's",
             extension);
  NewPoses poses;
  for (const ObjectId id : m_first.ids())
    if (session.scene().contains(id) &&
        !is_same_pose(session.scene().at(id).pose, m_first.at(id).pose))
      poses[id] = session.scene().at(id).pose;
  std::vector<SceneJoint> moved;
  const std::vector<SceneJoint>&now = joints(session.num_done()), &first = m_joints.at(0);
  for (size_t i = 0; i < now.size(); ++i)
    if (now[i].value != first[i].value) moved.push_back(now[i]);
  if (moved.empty())
    m_opened.write(poses, path);
  else
    m_opened.write_with_joints(poses, moved, path);
}

OpenedSession open_session_of_others(const std::string& file, const OpenOptions& options,
                                     const SettleOptions& given) {
  auto others = std::make_shared<OthersScene>(open_scene(file, options));
  const JudgedScene& judged = others->opened().judged;
  SettleOptions settle = given;
  if (!(settle.clearance > 0)) settle.clearance = judged.clearance;
  Scene scene = judged.scene;
  update_contacts(scene, settle.clearance, settle);
  Layout layout;
  layout.floor = scene.floor;
  layout.settle = rules_of(settle);
  std::vector<Sentence> notes = others->opened().notes;
  for (const Sentence& what : others->opened().unread) notes.push_back(say("not read: %1", what));
  if (judged.lift != 0)
    notes.push_back(
        say("heights count from the floor, which is at %1 m in the file", figure(-judged.lift)));
  return {Session(std::move(scene), std::move(layout), no_models()),
          file,
          folder_of(file),
          settle.clearance,
          std::move(notes),
          rules_of(settle),
          std::move(others)};
}

bool is_for_others(const Operation& operation) {
  return std::visit(
      [](const auto& o) {
        using T = std::decay_t<decltype(o)>;
        return !(std::is_same_v<T, AppendOperation> || std::is_same_v<T, DuplicateOperation> ||
                 std::is_same_v<T, DeleteOperation> || std::is_same_v<T, RenameOperation> ||
                 std::is_same_v<T, DrapeOperation> || std::is_same_v<T, UnplaceOperation> ||
                 std::is_same_v<T, MaterialOperation>);
      },
      operation);
}

}  // namespace trivet
