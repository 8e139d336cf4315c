// Document thread: runs the session, its files, its journal. Private.
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "apps/edit/document/arrange_worker.h"
#include "apps/edit/document/drag_goal.h"
#include "apps/edit/document/drag_motion.h"
#include "apps/edit/document/engine_news.h"
#include "apps/edit/document/file_lock.h"
#include "apps/edit/document/ghost_worker.h"
#include "apps/edit/document/look_steps.h"
#include "apps/edit/document/many.h"
#include "apps/edit/document/snapshot_maker.h"
#include "apps/edit/document/thread_detector.h"
#include "ops/operations/live_move.h"
#include "ops/session/restore.h"

namespace trivet::edit {

/// Functions above the line are for the thread of the windows, those below for jobs.
class Engine {
 public:
  /// @param receiver  object of the thread of the windows, on which the news are told.
  Engine(QObject& receiver, EngineNews& news, DocumentOptions options);
  ~Engine();

  using Work = std::function<bool(Engine&)>;
  /// @param work  @return whether it succeeded.
  void post(EngineNews::Job job, const std::string& what, Work work);
  void cancel();
  void begin_drag(std::uint64_t drag, const Operation& operation);
  /// Sets the goal; the latest wins.
  void steer(const DragGoal& goal);
  void cancel_drag(std::uint64_t drag);
  void request_ghost(std::uint64_t request, std::vector<Operation> choices,
                     std::shared_ptr<const SceneSnapshot> shown);
  void request_ways(ObjectId object);
  /// @param scene  number of the one that is shown: another one keeps its own.
  void set_wishes(std::uint64_t scene, std::string json);
  /// A change of looks, which windows show already, as a step. @param scene  as above.
  /// @param selection  before it.
  void add_look_step(std::uint64_t scene, LookStep step, Selection selection);
  void request_layout(std::uint64_t number, std::uint64_t seed, Wishes::Part part,
                      size_t num_entries);
  /// Requests up to this number.
  void cancel_layout(std::uint64_t number) { m_layouts.cancel(number); }
  /// Other detectors, made by the threads that ask, when nothing refers to the old ones.
  void choose_detection(BackendOptions options);
  /// Switches z-lists of dragged and previewed objects on or off.
  void watch_zlists(bool on) { m_watches = on; }
  /// True if no work or signal is pending.
  bool is_idle() const {
    // Workers open a signal before they are idle: it is looked for again after them.
    return m_num_open == 0 && m_ghosts.is_idle() && m_layouts.is_idle() && m_num_open == 0;
  }

  // ---------------------------------------------------------------------------------------------

  bool new_scene();
  bool open(const std::string& file);
  bool open_demo(const std::string& name);
  bool save_as(const std::string& file, const Looks& looks);
  bool export_to(const std::string& file, const Looks& looks);
  bool close();
  bool restore(const std::string& journal);
  bool perform(const Operation& operation);
  bool perform_all(const std::vector<Operation>& operations,
                   const std::vector<std::string>& select = {});
  /// The first of the choices that is done. @param drag  ends with it; 0: there is none.
  bool perform_first(const std::vector<OperationGroup>& choices,
                     const std::vector<std::string>& select, std::uint64_t drag);
  bool perform_groups(const std::string& what, const ManyObjects& many);
  bool import_model(const ImportModel& model);
  bool accept_layout(const LayoutGhost& layout);
  bool save_problem(const std::string& file, const std::string& arrange);
  bool go_to_step(size_t wanted);
  bool end_drag(std::uint64_t drag);
  size_t num_done() const;
  const std::string& file() const { return m_file; }

 private:
  struct Item {
    EngineNews::Job job = 0;  // 0: none that windows wait for, such as a part of a drag
    std::string what;
    Work work;
    std::uint64_t generation = 0;
  };
  void post(Item item);
  void run();
  bool run(const Item& item);
  void follow();
  void show_done(const std::vector<Operation>& operations, const OperationResult& result,
                 const std::optional<Pose>& from);
  void show_again();
  void renew_detector();
  BackendOptions with_notes(BackendOptions options);
  static BackendOptions until_measured(BackendOptions options);
  void use_measured();
  GhostWorker::Listener ghost_listener();
  ArrangeWorker::Listener layout_listener();
  SettleOptions settle_options() const;
  RunContext context() const;
  void tell(std::function<void(EngineNews&)> what);
  void tell(Message message);
  void tell(const OperationResult& result, const Operation& operation);
  bool tell_if_true(const RepairOperation& repair);

  /// Thrown when the user has cancelled.
  struct Cancelled {};
  /// @throws Cancelled
  void show_progress(const std::string& what, size_t done, size_t total);
  void tell_progress(const std::string& what, size_t done, size_t total);
  RunOptions run_options();
  void adopt(OpenedSession opened, const std::string& file, const std::string& title,
             std::unique_ptr<FileLock> lock);
  void leave_session();
  std::string new_journal() const;
  std::unique_ptr<FileLock> locked(const std::string& file) const;
  std::string model_path(const std::string& file) const;
  SceneLooks keep_looks(const Looks& looks);
  void tell_notes(const std::string& object);
  void publish(std::optional<SettledWay> way = std::nullopt);
  History history() const;
  bool undo_one();
  bool redo_one();
  void show_looks(const Looks& from, const Looks& to);
  /// Judges the scene as a whole, unless it has changed since.
  void judge(std::uint64_t committed);
  std::optional<Pose> pose_before(const std::vector<Operation>& operations) const;

  QObject& m_receiver;
  EngineNews& m_news;
  DocumentOptions m_options;
  std::atomic<bool> m_cancel = false;
  std::atomic<int> m_num_open = 0;  // posts and signals not yet delivered; detectors send notes

  std::optional<OpenedSession> m_opened;  // always set while jobs run
  std::uint64_t m_scene = 0;              // number of this session's scene
  LookSteps m_look_steps;
  bool m_is_behind = false;  // windows show the scene before steps that were undone or redone
  std::string m_file, m_title;
  std::unique_ptr<FileLock> m_lock;
  SnapshotMaker m_snapshots;
  ThreadDetector m_detector;
  Answering m_told;                // last shown
  std::optional<LiveMove> m_live;  // refers to the detector
  std::optional<DragMotion> m_motion;
  std::atomic<bool> m_watches = false;
  std::uint64_t m_drag = 0;
  std::uint64_t m_published = 0;  // SceneSnapshot::committed
  bool m_ghosts_know = false;     // the ghost worker has the current scene

  std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::deque<Item> m_items;
  std::uint64_t m_generation = 0;
  BackendOptions m_chosen;
  std::optional<DragGoal> m_goal;
  bool m_stop = false;
  GhostWorker m_ghosts;
  ArrangeWorker m_layouts;
  std::thread m_thread;
};

}  // namespace trivet::edit
