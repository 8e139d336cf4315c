// Protocol of `trivet session` and `trivet serve`: a session is asked by lines of JSON, and each is
// answered by a line; apps/trivet/README.md describes them.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "core/scene/fingerprint.h"
#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/json/text.h"
#include "ops/mend/mend.h"
#include "ops/session/restore.h"
#include "ops/session/told_poses.h"

namespace trivet {

struct DialogueOptions {
  SettleOptions settle;    // before the rules that the opened file states
  RunContext context;      // without `cancel`, which every line has of its own
  std::string version;     // of the program, for saved scenes
  std::string source;      // of the lines, for messages: "standard input"
  bool own_files = false;  // clients are not trusted with files: nothing is saved, and models are
                           // read from the folder of the start file and below it
  size_t max_states = 0;   // Session::limit_history(); 0: any number
  size_t max_objects = 0;  // that a line may make of the scene; 0: any number
  size_t max_text_bytes = 0;  // of a name or another text in a line; 0: any number
};

/// True if the line asks that all unfinished lines before it are cancelled.
bool is_cancel_line(const std::string& line);

class Dialogue {
 public:
  /// @param opened  outlives the dialogue, and is changed by nothing else.
  Dialogue(OpenedSession& opened, DialogueOptions options);
  ~Dialogue();
  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  struct Answer {
    std::string status;  // "ok", "refused", "cancelled", "out of time" or "error"
    std::string text;    // JSON without line breaks
  };

  /// Answers first contacts from now on; null: BVHs. Not owned.
  void use(Detector* detector) { m_options.context.detector = detector; }
  /// Greets: the state of the session.
  Answer greeting() const;
  /// Errors of a line are its answer; it throws std::bad_alloc alone.
  /// @param cancelled  may be set by another thread; outlives the call.
  Answer answer(const std::string& line, const std::atomic<bool>& cancelled);
  /// The scene as it is, judged from its poses alone. Its points count from the session's floor.
  SceneVerdict verdict() const;
  /// Joints as they are.
  std::vector<SceneJoint> joints() const;

 private:
  OrderedJson state() const;
  OrderedJson answered(const std::string& line);
  OrderedJson done(const nlohmann::json& document, const JsonPlace& place);
  OrderedJson perform(const std::vector<Operation>& operations);
  OrderedJson undo();
  OrderedJson save(const JsonPlace& file);
  OrderedJson query(const JsonPlace& what) const;
  OrderedJson object(const std::string& name) const;
  OrderedJson objects() const;
  OrderedJson check() const;
  OrderedJson joint_list() const;
  OrderedJson mend(const JsonPlace& how);
  OrderedJson settle(const JsonPlace& how);
  void begin(MendOptions& options) const;
  OrderedJson repaired(const char* step, const SettledScene& repaired, const OrderedJson& told);
  OrderedJson move_joint(const JsonPlace& request);
  OrderedJson move_own_joint(const std::string& link, double goal);
  void check_room(const std::vector<Operation>& operations, const JsonPlace& place) const;
  Operation read(const JsonPlace& place) const;
  std::vector<Operation> read_all(const JsonPlace& place) const;

  OpenedSession& m_opened;
  Session& m_session;
  DialogueOptions m_options;
  ToldPoses m_told;
  SceneState m_state;
  std::vector<ObjectId> m_changed;  // by the line that is being answered
};

}  // namespace trivet
