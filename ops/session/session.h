// A session: every operation is a step that can be undone and redone, without limit and to the bit;
// a journal keeps the steps on disk. Start here; journal.h is the file, restore.h opens and
// restores sessions.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"
#include "ops/files/layout/layout.h"
#include "ops/files/layout/load.h"
#include "ops/operations/operations.h"
#include "ops/session/recorded.h"

namespace trivet {

class Journal;
class LiveMove;
class Transaction;

/// Operations that are done and undone as one.
struct SessionStep {
  std::string name;                           // "put \"cup\"", "delete 3 objects"
  std::vector<Operation> operations;          // one, but for perform_all(); none: of place()
  SettleOptions settle;                       // it was done with
  std::uint64_t fingerprint = 0;              // of the objects it changed, as it left them
  std::vector<OperationResult> results = {};  // of the operations, without their steps to watch
};

/// Change that an editor has to show.
struct SessionEvent {
  enum class Kind { Performed, Refused, Undone, Redone, Saved };
  Kind kind;
  std::string step;                         // its name; of Saved: the file
  std::vector<ObjectId> changed;            // objects that came, went or look otherwise
  const OperationResult* result = nullptr;  // of Performed and Refused
};

/// One thread at a time; only RunContext::cancel may be set from another.
class Session {
 public:
  /// @param layout  what made the scene, as SceneFile::layout.
  /// @param models  where appended objects come from; may be empty, then append is refused.
  Session(Scene scene, Layout layout, ModelSource models);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  const Scene& scene() const { return m_scene; }

  /// The whole operation or nothing; when done it is the next step, steps that were undone are
  /// forgotten, and the journal has it on disk before this returns.
  /// @throws Error: BadInput when an appended model cannot be read; Environment when the journal
  ///   cannot be written. The scene is then as it was.
  OperationResult perform(const Operation& operation, const SettleOptions& options = {},
                          const RunContext& context = {});

  /// Several operations as one step; when one is refused, none is done, and its result comes back.
  /// Else the last one's. @param operations  one at least. @throws Error  as perform().
  OperationResult perform_all(const std::vector<Operation>& operations,
                              const SettleOptions& options = {}, const RunContext& context = {});

  /// A step whose outcome is known: as perform_all(), but nothing is computed, and these objects
  /// get their poses. See recorded_step.h. @throws Error  as perform().
  void repeat(const std::vector<Operation>& operations, const SettleOptions& options,
              const RecordedPoses& poses);

  /// A step of poses alone, which no operation tells: a mended scene, a moved joint. @throws Error
  ///   as perform().
  void place(const std::string& name, const RecordedPoses& poses, const SettleOptions& options);

  /// An interactive move; see ops/operations/live_move.h. While it lives, this session is neither
  /// moved nor are its other non-const functions called, but for finish().
  LiveMove begin_live(const Operation& operation, const SettleOptions& options = {},
                      const RunContext& context = {});
  /// Ends it: as perform() of its operation, to the bit, but without going the way again.
  OperationResult finish(LiveMove& live);

  /// @return whether there was something to undo (redo). @throws Error (Environment) as perform().
  bool undo();
  bool redo();
  bool can_undo() const { return m_position > 0; }
  bool can_redo() const { return m_position < m_steps.size(); }

  /// All steps that are not forgotten, those that can be redone last; the first num_done() of them
  /// are done.
  const std::vector<SessionStep>& steps() const { return m_steps; }
  size_t num_done() const { return m_position; }

  /// Largest number of states of objects that the steps keep for undo; the oldest steps are
  /// forgotten until these fit, but never the last one. For sessions without a journal. 0: any
  /// number.
  void limit_history(size_t max_states) { m_max_states = max_states; }
  size_t num_forgotten() const { return m_num_forgotten; }

  /// Layout that gives this scene: the first one and the operations done since; once steps were
  /// forgotten, or there are steps of poses alone, the objects in their poses.
  Layout layout() const;
  /// Sets the looks of the layout. This is no step: neither undone nor in the journal.
  void set_looks(SceneLooks looks) { m_layout.looks = std::move(looks); }

  /// Problem to be arranged, kept with the layout (Layout::arrange); neither a step nor in the
  /// journal.
  const std::string& arrange() const { return m_layout.arrange; }
  void set_arrange(std::string text) { m_layout.arrange = std::move(text); }

  /// Metres: the largest default clearance that the scene has had, undone steps apart. What was at
  /// rest by it when the scene was larger is no less so when it has shrunk: the scene is to be
  /// judged by this.
  double largest_clearance() const {
    return m_position > 0 ? m_done[m_position - 1].largest_clearance : m_first_clearance;
  }

  /// The scene as it is now is what the file has.
  void mark_saved(const std::string& file);
  /// True if steps were done or undone since then.
  bool is_modified() const;
  /// The objects that those steps touched; those that are gone too. Sorted by slot.
  std::vector<ObjectId> changed_since_saving() const;

  /// Told after every step, and of refusals. It must not call the session's non-const functions.
  void on_event(std::function<void(const SessionEvent&)> callback);

  /// From now on every step is on disk before it counts.
  void keep_journal(std::unique_ptr<Journal> journal);
  const Journal* journal() const { return m_journal.get(); }

 private:
  struct Done {
    SceneChange change;             // undoes it, or redoes it
    std::vector<ObjectId> touched;  // before and after it
    double largest_clearance = 0;   // from the start up to this step
  };
  size_t num_states(size_t step) const { return 1 + m_done[step].touched.size(); }
  void forget_oldest();
  void forget_first(size_t count);

  using Results = std::vector<OperationResult>;
  std::vector<Operation> with_models(std::vector<Operation> operations) const;
  OperationResult run(SessionStep step, const std::function<Results(Transaction&)>& work);
  void keep(Transaction& transaction, SessionStep& step);
  std::vector<ObjectId> changed_aside_without_undone() const;
  void forget_undone(std::vector<ObjectId> changed_aside) noexcept;
  void step_over(size_t step, SessionEvent::Kind kind);
  void tell(const SessionEvent& event) const;

  Scene m_scene;
  Layout m_layout;
  ModelSource m_models;
  std::vector<SessionStep> m_steps;
  std::vector<Done> m_done;  // of each step
  size_t m_position = 0;
  size_t m_max_states = 0, m_num_states = 0, m_num_forgotten = 0;
  double m_first_clearance = 0;           // the default one at the start
  std::string m_saved_arrange;            // Layout::arrange then
  size_t m_saved = 0;                     // how many steps were done when it was saved
  std::vector<ObjectId> m_changed_aside;  // by steps between the saved state and m_saved that were
                                          // undone and forgotten
  std::unique_ptr<Journal> m_journal;
  std::function<void(const SessionEvent&)> m_callback;
};

}  // namespace trivet
