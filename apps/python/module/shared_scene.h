// A session that several Python threads share: one at a time, all or nothing, undone in groups.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "apps/python/module/detectors.h"
#include "apps/python/module/drawn_looks.h"
#include "apps/python/module/running.h"
#include "ops/files/animation/motion_film.h"
#include "ops/session/restore.h"

namespace trivet::python {

/// Names an object for Python: its id as a number, and the name that it must still have.
using ObjectKey = std::uint64_t;
inline ObjectKey key_of(ObjectId id) {
  return (static_cast<ObjectKey>(id.generation) << 32) | id.index;
}

struct OpenTransaction;

class SharedScene {
 public:
  explicit SharedScene(OpenedSession opened) : m_opened(std::move(opened)) {}

  SettleOptions settle;
  double time_budget_s = 0;  // of each operation; 0: none
  std::shared_ptr<ChosenDetectors> detectors = detectors_of("auto", "auto");
  const std::shared_ptr<DrawnLooks> looks = std::make_shared<DrawnLooks>();

  const Scene& scene() const { return m_opened.session.scene(); }
  OpenedSession& opened() { return m_opened; }
  Session& session() { return m_opened.session; }

  /// @throws NoSuchObject (Python) when it is gone.
  const Object& at(ObjectKey key, const std::string& name) const;
  ObjectId id(ObjectKey key, const std::string& name) const;

  /// Does these as one step; see Session::perform_all(). With the GIL, under a SceneGuard.
  OperationResult perform(const std::vector<Operation>& operations, double budget_s);
  /// Set to stop the operation under way.
  std::atomic<bool>& cancel() { return m_cancel; }
  RunContext context(double budget_s, Detector* detector) const;
  /// Python warnings of what the detectors had to say. With the GIL.
  void warn_of_detectors();

  /// A step has been done (or several): they are undone as one.
  void end_group();
  /// Ends the innermost transaction; with the GIL, while nothing runs.
  void end_transaction(bool keep);
  /// Takes back transactions that nobody can end any more, as far as the scene is free for it.
  void take_back_abandoned();
  /// Takes back all steps after this many.
  void roll_back(size_t num_done);
  bool undo();
  bool redo();
  bool can_undo() const { return m_position > 0; }
  bool can_redo() const { return m_position < m_group_ends.size(); }
  /// Another scene instead; its history begins there.
  void replace(OpenedSession opened);

  /// Record of what moves; none unless it was asked for.
  std::optional<MotionFilm> film;

  /// Transactions that are open, the innermost last; all of the thread that holds the scene.
  std::vector<std::shared_ptr<OpenTransaction>> transactions;
  /// A hand holds an object: nothing else may change.
  bool is_dragged = false;

 private:
  friend class SceneGuard;

  void record(const std::vector<Operation>& operations, const OperationResult& result);

  OpenedSession m_opened;
  std::atomic<bool> m_cancel = false;
  std::vector<size_t> m_group_ends;  // steps of the session that are done after each group
  size_t m_position = 0;             // groups that are done

  // The lock: recursive, of a thread. The GIL guards it, so that a fork finds it whole.
  std::thread::id m_owner;
  int m_owner_forks = 0;  // num_forks() when it was taken
  int m_depth = 0;
  bool m_is_running = false;  // an operation; callbacks of it must not come back
};

/// Holds a scene for this thread. Made and ended with the GIL; waits without it, and Ctrl+C ends
/// the wait.
class SceneGuard {
 public:
  enum class Use { Read, Change };
  /// @throws SceneBusy (Python): from a callback of an operation of this scene; a change while a
  ///   hand drags; in a process that was forked while another thread held the scene.
  explicit SceneGuard(SharedScene& scene, Use use = Use::Read);
  ~SceneGuard();
  /// @throws SceneBusy (Python): in another thread than the one that holds the scene; while an
  ///   operation runs. @param what  holds this: "the drag".
  void check_own(const std::string& what) const;
  SceneGuard(const SceneGuard&) = delete;
  SceneGuard& operator=(const SceneGuard&) = delete;

  /// Calls f() without the GIL; meanwhile the scene is refused to this thread, too.
  template <class F>
  auto run(F&& f) {
    const Running running(m_scene.m_is_running);
    return without_gil(std::forward<F>(f));
  }

 private:
  struct Running {
    explicit Running(bool& flag) : is_running(flag) { is_running = true; }
    ~Running() { is_running = false; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    bool& is_running;
  };
  SharedScene& m_scene;
};

/// Steps that are done together or not at all; holds the scene meanwhile.
struct OpenTransaction {
  std::unique_ptr<SceneGuard> guard;
  size_t begin = 0;           // steps that were done before it
  bool is_abandoned = false;  // to be taken back, as it was never ended
};

}  // namespace trivet::python
