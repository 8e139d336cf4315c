// The document of the editor: a session on a thread of its own, so that no window ever waits.
//
// Everything that takes time is a job. Jobs are done one after another; a call returns the job's
// number at once, signals tell how it goes, and finished() that it has ended. All functions are for
// the thread of the windows; signals come there, too. What is drawn is snapshot(), which no running
// operation changes.
//
//   tools and menus -> Document -> jobs -> Session (ops/session) -> snapshot -> signals -> windows
//
// Start here; snapshot.h is what windows read.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/edit/document/ghost.h"
#include "apps/edit/document/message.h"
#include "apps/edit/document/selection.h"
#include "apps/edit/document/snapshot.h"
#include "core/io/model.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

class Engine;
struct DragGoal;

struct DocumentOptions {
  /// Where what a crash must not lose is kept: journals, demos, locks. Empty: nothing is kept.
  std::string recovery_folder;
  std::string version;   // of the program; stands in saved files
  SettleOptions settle;  // of all operations
  RunContext context;
  int num_threads = 0;   // of loading; 0: all cores
  ImportLimits limits;
};

/// All steps of the session; those that can be redone last.
struct History {
  std::vector<std::string> steps;  // "put \"cup\""
  size_t num_done = 0;
};

/// A session that did not end as it should.
struct Recoverable {
  std::string journal;
  std::string file;  // that was open; empty: a scene that had never been saved
  std::string when;  // of the last step, local time, "2026-11-21 17:54"
  size_t num_steps = 0;
};

/// How a model comes in.
struct ImportModel {
  std::string file;
  std::string name;          // empty: of the file; made unique
  double scale = 1;          // metres per unit of the file
  std::optional<UpAxis> up;  // nothing: as the format says
  bool fixed = false;
  std::optional<Pose> put;  // nothing: out of the scene until it is put
};

class Document : public QObject {
  Q_OBJECT

 public:
  using Job = quint64;  // never 0

  explicit Document(DocumentOptions options, QObject* parent = nullptr);
  /// Cancels what is running. A modified scene can be recovered unless close() was called.
  ~Document() override;

  // --- what there is ---------------------------------------------------------------------------

  /// Never null. The same until snapshot_changed().
  const std::shared_ptr<const SceneSnapshot>& snapshot() const { return m_snapshot; }
  const History& history() const { return m_history; }
  bool can_undo() const { return m_history.num_done > 0; }
  bool can_redo() const { return m_history.num_done < m_history.steps.size(); }
  bool is_modified() const { return m_modified; }
  /// What save() writes; empty: it has no name yet, or what was opened is a layout.
  const std::string& file() const { return m_file; }
  /// For titles: the file that was opened or saved, or "Untitled", or a demo's name.
  const std::string& title() const { return m_title; }
  /// Whether a job is waiting or running. Drags are none.
  bool is_busy() const { return m_num_jobs > 0; }
  const std::string& busy_with() const { return m_busy_with; }  // "open \"x.glb\""
  /// Where the hand last was and what followed it: milliseconds from drag_to() or drag_by() to
  /// snapshot_changed(), of the last drag.
  const std::vector<double>& drag_milliseconds() const { return m_drag_milliseconds; }

  // --- files -----------------------------------------------------------------------------------
  // Nobody is asked whether unsaved work may be lost: that is for the caller, before. When opening
  // fails, the document is as it was.

  Job new_scene();
  Job open(const std::string& file);  // .glb or .json
  Job open_demo(const std::string& name);
  /// Under file(), which must not be empty.
  Job save();
  /// .glb; or .json: the layout that makes this scene (the document keeps its file then).
  Job save_as(const std::string& file);
  /// .obj, .ply, .stl or .glb; the document keeps its file.
  Job export_to(const std::string& file);
  /// Nothing is left to recover from this session.
  Job close();

  std::vector<Recoverable> recoverable() const;
  Job restore(const std::string& journal);
  void discard(const std::string& journal);

  // --- operations ------------------------------------------------------------------------------

  Job perform(const Operation& operation);
  /// One after the other, undone as one; when one is refused, none is done.
  /// @param name  what windows call it while it is busy. @param select  objects that are selected
  /// when it is done; empty: the selection stays.
  Job perform_all(const std::string& name, std::vector<Operation> operations,
                  std::vector<std::string> select = {});
  /// One step; the new object is selected when it is done. Where it cannot be put it is out of the
  /// scene all the same.
  Job import_model(const ImportModel& model);
  Job undo();
  Job redo();
  /// So that this many steps are done.
  Job go_to_step(size_t num_done);
  /// Stops what is running, and forgets what waits; the scene is as before.
  void cancel();

  // --- selection -------------------------------------------------------------------------------

  const Selection& selection() const { return m_selection; }
  /// What is not in the scene is left out.
  void select(Selection selection);
  void select_only(std::optional<ObjectId> id);

  // --- drags ----------------------------------------------------------------------------------

  /// A move that follows the hand from now on. @param operation  PUSH, TURN, PICK-UP, TRANSLATE or
  /// ROTATE; how far does not matter.
  void begin_drag(const Operation& operation);
  /// Where the hand is. PUSH: where the object's position shall be, seen from above (x, y).
  /// TRANSLATE: how far it shall be from where it was at the beginning.
  void drag_to(const Vec3& goal);
  /// TURN and ROTATE: degrees from the beginning. PICK-UP: metres.
  void drag_by(double amount);
  /// Commits as one step. @return the job, or 0 when nothing is dragged.
  Job end_drag();
  /// All is as before the drag.
  void cancel_drag();
  bool is_dragging() const { return m_dragging; }

  // --- ghost -----------------------------------------------------------------------------------

  /// Where `operation` would bring its object; the latest request wins. ghost_changed() tells.
  void request_ghost(const Operation& operation);
  void clear_ghost();
  const std::optional<Ghost>& ghost() const { return m_ghost; }

  /// Runs the event loop until nothing is busy, dragged or asked for. For tests.
  /// @return whether that was so within the time.
  bool wait_until_idle(int timeout_ms = 60000);

 Q_SIGNALS:
  void snapshot_changed();
  void selection_changed();
  void history_changed();  // is_modified(), too
  void file_changed();     // file(), title(), is_modified()
  void busy_changed();
  /// @param total  0: it is not known how much there is.
  void progressed(const QString& what, int done, int total);
  void message(const trivet::edit::Message& message);
  void ghost_changed();
  void drag_ended(bool committed);
  void finished(quint64 job, bool ok);

 private:
  /// What jobs leave behind: all that windows show.
  struct State {
    std::shared_ptr<const SceneSnapshot> snapshot;
    History history;
    std::string file, title;
    bool modified = false;
  };
  friend class Engine;
  Job start(const std::string& what, std::function<bool(Engine&)> work);
  void steer(DragGoal goal);
  void end(Job job, bool ok);
  void show(State state);
  void show_scene(std::shared_ptr<const SceneSnapshot> snapshot);
  void show_drag(std::shared_ptr<const SceneSnapshot> snapshot, std::uint64_t drag, double ms);
  void show_ghost(std::uint64_t request, Ghost ghost);
  void drag_refused(std::uint64_t drag);
  void set_selection(Selection selection);
  void select_named(const std::vector<std::string>& names);

  DocumentOptions m_options;
  std::shared_ptr<const SceneSnapshot> m_snapshot;
  Selection m_selection;
  History m_history;
  std::string m_file, m_title, m_busy_with;
  std::optional<Ghost> m_ghost;
  std::uint64_t m_drag = 0, m_ghost_request = 0;  // the last ones
  std::vector<double> m_drag_milliseconds;
  bool m_modified = false, m_dragging = false;
  int m_num_jobs = 0;
  Job m_last_job = 0;
  std::unique_ptr<Engine> m_engine;
};

}  // namespace trivet::edit
