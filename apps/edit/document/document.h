// The editor's document: a session on a thread of its own, so that windows never wait.
//
// Lengthy work runs as jobs, one after another; a call returns the job's number at once, signals
// report progress, and finished() its end. All functions are for the thread of the windows; signals
// arrive there too. Windows draw snapshot(), which running operations never change.
//
//   tools and menus -> Document -> jobs -> Session (ops/session) -> snapshot -> signals -> windows
//
// Start here; windows read snapshot.h.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/edit/document/document_options.h"
#include "apps/edit/document/engine_news.h"
#include "apps/edit/document/ghost.h"
#include "apps/edit/document/layout_ghost.h"
#include "apps/edit/document/look_steps.h"
#include "apps/edit/document/looks.h"
#include "apps/edit/document/many.h"
#include "apps/edit/document/message.h"
#include "apps/edit/document/object_changes.h"
#include "apps/edit/document/scene_verdict.h"
#include "apps/edit/document/selection.h"
#include "apps/edit/document/snapshot.h"
#include "apps/edit/document/ways_to_lie.h"
#include "apps/edit/document/wishes.h"
#include "apps/edit/document/zlist_view.h"
#include "core/base/sentence.h"

namespace trivet::edit {

class Engine;
struct DragGoal;

class Document : public QObject, private EngineNews {
  Q_OBJECT

 public:
  using Job = EngineNews::Job;

  explicit Document(DocumentOptions options, QObject* parent = nullptr);
  /// Cancels the running job. A modified scene can be recovered unless close() was called.
  ~Document() override;

  // --- state -----------------------------------------------------------------------------------

  /// Never null. The same until snapshot_changed().
  const std::shared_ptr<const SceneSnapshot>& snapshot() const { return m_snapshot; }
  /// Verdict on the committed scene as a whole; null: not judged yet. Until verdict_changed().
  std::shared_ptr<const SceneVerdict> verdict() const;
  const History& history() const { return m_history; }
  bool can_undo() const { return m_history.num_done > 0; }
  bool can_redo() const { return m_history.num_done < m_history.steps.size(); }
  /// Looks count, too.
  bool is_modified() const;
  /// Target of save(); empty: unnamed, or a layout was opened.
  const std::string& file() const { return m_file; }
  /// Title for windows: the opened or saved file, "Untitled", or a demo's name.
  const std::string& title() const { return m_title; }
  /// True while a job is waiting or running. Drags do not count.
  bool is_busy() const { return m_num_jobs > 0; }
  const std::string& busy_with() const { return m_busy_with; }  // "open \"x.glb\""
  const ImportLimits& import_limits() const { return m_options.limits; }
  /// Latency of the last drag: milliseconds from drag_to() or drag_by() to snapshot_changed().
  const std::vector<double>& drag_milliseconds() const { return m_drag_milliseconds; }

  // --- files -----------------------------------------------------------------------------------
  // No function asks whether to save first: the caller must do so. If opening fails, the document
  // is unchanged.

  Job new_scene();
  Job open(const std::string& file);  // .glb or .json
  Job open_demo(const std::string& name);
  /// Saves to file(), which must not be empty.
  Job save();
  /// Saves as .glb, or as .json: the layout that makes this scene (the document keeps its file
  /// then).
  Job save_as(const std::string& file);
  /// In any of scene_formats(); the document keeps its file.
  Job export_to(const std::string& file);
  /// Ends the session and removes its recovery files.
  Job close();

  std::vector<Recoverable> recoverable() const;
  Job restore(const std::string& journal);
  void discard(const std::string& journal);

  // --- operations ------------------------------------------------------------------------------

  Job perform(const Operation& operation);
  /// Runs operations in order as one undoable step; if one is refused, none is committed.
  /// @param name  shown by windows while busy. @param select  objects to select on success; empty:
  ///   keep the selection.
  Job perform_all(const std::string& name, std::vector<Operation> operations,
                  std::vector<std::string> select = {});
  /// The first of these operations that is done, as one step; a drag ends with it. Refused as the
  /// first is.
  Job perform_first(std::vector<Operation> choices);
  /// Runs the groups as one step and selects their objects; a group that is refused is left out,
  /// and a message tells how many and why. @param name  shown by windows while busy.
  Job perform_groups(const std::string& name, ManyObjects many);
  /// As one step; see remake.h.
  Job rescale(const std::string& name, double scale, double drop_height);
  Job rescale(const std::string& name, double scale, UpAxis up, double drop_height);
  /// Imports as one step; the new object is selected on success. If it cannot be put, it stays
  /// unplaced.
  Job import_model(const ImportModel& model);
  Job undo();
  Job redo();
  /// Undoes or redoes until this many steps are done.
  Job go_to_step(size_t num_done);
  /// Stops the running job and drops waiting ones; the scene is unchanged.
  void cancel();

  // --- selection -------------------------------------------------------------------------------

  const Selection& selection() const { return m_selection; }
  /// Objects that are not in the scene, or not selectable, are dropped. Undo brings back what was
  /// selected when the objects that are selected now go.
  void select(Selection selection);
  void select_only(std::optional<ObjectId> id);

  /// Looks of this scene, until another one is opened. Saved with it.
  const Looks& looks() const { return m_looks; }
  /// As one undoable step. @param name  of the step, for the history.
  void set_looks(Looks looks, const std::string& name = "looks");

  // --- drags ----------------------------------------------------------------------------------

  /// Starts an interactive move. @param operation  PUSH, TURN, PICK-UP, TRANSLATE or ROTATE; its
  /// distance or angle is ignored.
  void begin_drag(const Operation& operation);
  /// Sets the goal of the drag. PUSH: target position of the object, seen from above (x, y).
  /// TRANSLATE: displacement since the start.
  void drag_to(const Vec3& goal);
  /// Sets the goal for TURN and ROTATE in degrees since the start, for PICK-UP in metres.
  void drag_by(double amount);
  /// Commits as one step. @return the job, or 0 if no drag is active.
  Job end_drag();
  /// Restores the state before the drag.
  void cancel_drag();
  bool is_dragging() const { return m_dragging; }

  // --- ghost -----------------------------------------------------------------------------------

  /// Requests the resulting pose of `operation`; the latest request wins. ghost_changed() answers.
  void request_ghost(const Operation& operation);
  /// The same of the first of these that is done. Where none is, a ghost of the same object that
  /// is done stays, and hangs back.
  void request_ghost_in_hand(std::vector<Operation> choices);
  /// True if the ghost answers the latest request.
  bool is_ghost_current() const { return m_ghost && m_ghost_answered == m_ghost_request; }
  void clear_ghost();
  const std::optional<Ghost>& ghost() const { return m_ghost; }

  /// ways_found() answers.
  void request_ways(ObjectId object);

  // --- arrangements ----------------------------------------------------------------------------

  /// Kept with the scene when it is saved. They follow objects that get another name.
  const Wishes& wishes() const { return m_wishes; }
  /// Invalid wishes are refused, with a message.
  void set_wishes(Wishes wishes);
  /// Looks for an arrangement of all objects, or of those selected with the others as they stand,
  /// on a thread of its own; the latest request wins. layout_changed() answers.
  /// @return false: there is none to arrange.
  bool request_layout(std::uint64_t seed, bool selected_only);
  void clear_layout();
  /// Null: none was asked for, or it is looked for.
  const std::shared_ptr<const LayoutGhost>& layout() const { return m_layout; }
  bool is_seeking_layout() const { return m_seeking; }
  /// As one step, of the scene that it was found for. @return 0: there is none.
  Job accept_layout();
  /// A problem of `trivet arrange`: all objects that may move, and the wishes.
  Job save_problem(const std::string& file);
  /// Loads the wishes of a problem, or of its section "arrange". @throws Error  and keeps the
  /// wishes.
  void load_wishes(const std::string& file);

  // --- detection -------------------------------------------------------------------------------

  /// Other detectors from the next move on; results do not depend on it. Each thread makes its own
  /// when no move refers to the old one.
  void choose_detection(BackendOptions options);
  const Detection& detection() const { return m_detection; }

  /// Switches the z-lists of the motion under the hand on or off: of drags, and of the fall of a
  /// PUT that is previewed. On the thread of ghosts, for at most a fifth of its time.
  void watch_zlists(bool on);
  bool watches_zlists() const { return m_watches; }
  /// The latest; null: none yet.
  const std::shared_ptr<const ZListView>& zlists() const { return m_zlists; }

  /// Runs the event loop until no job, drag or ghost is pending. For tests.
  /// @return false on timeout.
  bool wait_until_idle(int timeout_ms = 60000);

 Q_SIGNALS:
  void scene_replaced();  // by a file or a new one, which snapshot_changed() shows next
  void snapshot_changed();
  void verdict_changed();
  void selection_changed();
  void looks_changed();
  void history_changed();  // is_modified(), too
  void file_changed();     // file(), title(), is_modified()
  void busy_changed();
  /// @param total  0: unknown.
  void progressed(const QString& what, int done, int total);
  void message(const trivet::edit::Message& message);
  void ghost_changed();
  void ways_found(const trivet::edit::WaysToLie& ways);
  void wishes_changed();
  void layout_changed();
  void layout_progressed(const QString& thing, int done, int total);
  void detection_changed();
  /// Why another detector answers than was chosen. Each note once per choice.
  void detection_noted(const QString& note);
  void zlists_changed();
  void drag_ended(bool committed);
  void finished(quint64 job, bool ok);

 private:
  Job start(const std::string& what, std::function<bool(Engine&)> work);
  void steer(const DragGoal& goal);
  void restore_selection(size_t steps_before);
  void follow(const ObjectChanges& changes);

  // News of the engine.
  void begin(const std::string& what) override;
  void end(Job job, bool ok) override;
  void tell(const Message& told) override { Q_EMIT message(told); }
  void show_progress(const std::string& what, int done, int total) override;
  void show(State state) override;
  void show_modified(bool modified) override;
  void forget_scene(std::uint64_t next) override;
  void show_scene(std::shared_ptr<const SceneSnapshot> snapshot) override;
  void show_verdict(std::shared_ptr<const SceneVerdict> verdict) override;
  void select_named(const std::vector<std::string>& names) override;
  void show_drag(std::shared_ptr<const SceneSnapshot> snapshot, std::uint64_t drag,
                 double ms) override;
  void drag_refused(std::uint64_t drag) override;
  void finish_drag(bool committed) override { Q_EMIT drag_ended(committed); }
  void show_ghost(std::uint64_t request, Ghost ghost) override;
  void show_ways(const WaysToLie& ways) override { Q_EMIT ways_found(ways); }
  void show_wishes(const std::string& json) override;
  void show_layout(std::uint64_t number, std::shared_ptr<const LayoutGhost> layout) override;
  void show_layout_progress(std::uint64_t number, const std::string& thing, int done,
                            int total) override;
  void show_zlists(std::shared_ptr<const ZListView> view) override;
  void show_moves_by(const Answering& answering) override;
  void show_previews_by(const Answering& answering) override;
  void show_detection_note(const Sentence& note) override;
  void show_looks(const SceneLooks& looks) override;
  void show_saved_looks(const SceneLooks& looks) override { m_saved_looks = looks; }
  void show_looks_of_step(const Looks& from, const Looks& to) override;
  void show_look_step(const History& history, const Selection& before) override;
  void show_history(const History& history) override;

  void set_selection(Selection selection);
  void put_looks(Looks looks);

  DocumentOptions m_options;
  std::shared_ptr<const SceneSnapshot> m_snapshot;
  std::shared_ptr<const SceneVerdict> m_verdict;
  Selection m_selection;
  std::map<size_t, Selection> m_selections;  // by steps done: when the next one began
  Looks m_looks;
  SceneLooks m_saved_looks;
  std::deque<LookStep> m_open_looks;  // changes that are no steps yet
  History m_history;
  std::string m_file, m_title, m_busy_with;
  std::optional<Ghost> m_ghost;
  std::uint64_t m_scene = 0;   // number of the scene, see Engine::adopt()
  bool m_is_replaced = false;  // the next snapshot is of another scene
  Wishes m_wishes;
  std::shared_ptr<const LayoutGhost> m_layout;
  std::uint64_t m_layout_request = 0;
  bool m_seeking = false;
  Detection m_detection;
  std::set<std::string> m_detection_notes;  // since the last choice
  std::shared_ptr<const ZListView> m_zlists;
  std::uint64_t m_drag = 0, m_ghost_request = 0;  // numbers of the latest ones
  std::uint64_t m_ghost_answered = 0;             // the same of answers
  bool m_ghost_hangs_back = false;                // the latest request's may
  std::vector<double> m_drag_milliseconds;
  bool m_modified = false, m_dragging = false, m_watches = false;
  int m_num_jobs = 0;
  Job m_last_job = 0;
  std::unique_ptr<Engine> m_engine;
};

}  // namespace trivet::edit
