// Scenes of other programs in sessions: their joints at every step, and the way back into their
// files. Positions in a session are those of its scene, with the floor at z = 0.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ops/files/foreign/open_scene.h"
#include "ops/operations/operation_run.h"
#include "ops/session/session.h"

namespace trivet {

struct OpenedSession;

/// Everything that a session on such a scene has beside its steps. One thread at a time.
class OthersScene {
 public:
  explicit OthersScene(OpenedScene opened);

  const OpenedScene& opened() const { return m_opened; }
  /// Joints as they are after this number of steps.
  const std::vector<SceneJoint>& joints(size_t num_done) const;
  /// Steps from here on were undone and are forgotten.
  void forget_from(size_t num_done);

  /// One step of the session, where the joint moved at all. See move_joint_of().
  JointMove move(Session& session, const std::string& joint, double to, const OperationRun& run);

  /// Writes the scene as the session has it; only numbers that differ from the file's change.
  /// @throws Error as OpenedScene::write; BadInput for another extension than the start's.
  void write(const Session& session, const std::string& path) const;

 private:
  OpenedScene m_opened;
  Scene m_first;                                       // as the file has it
  std::map<size_t, std::vector<SceneJoint>> m_joints;  // after this number of steps and more
};

/// A session on a scene of another program.
/// @throws Error as open_scene().
OpenedSession open_session_of_others(const std::string& file, const OpenOptions& options,
                                     const SettleOptions& settle);

/// False for operations that change the list of objects or what the file has no place for.
bool is_for_others(const Operation& operation);

}  // namespace trivet
