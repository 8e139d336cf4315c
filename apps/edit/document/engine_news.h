// News of the engine for the document, which calls these on the thread of the windows.
#pragma once

#include <QtGlobal>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "apps/edit/document/document_options.h"
#include "apps/edit/document/ghost.h"
#include "apps/edit/document/layout_ghost.h"
#include "apps/edit/document/look_steps.h"
#include "apps/edit/document/looks.h"
#include "apps/edit/document/message.h"
#include "apps/edit/document/scene_verdict.h"
#include "apps/edit/document/selection.h"
#include "apps/edit/document/snapshot.h"
#include "apps/edit/document/ways_to_lie.h"
#include "apps/edit/document/zlist_view.h"
#include "core/base/sentence.h"

namespace trivet::edit {

class EngineNews {
 public:
  using Job = quint64;  // never 0

  /// Results of jobs: the state shown by windows.
  struct State {
    std::shared_ptr<const SceneSnapshot> snapshot;
    History history;
    std::string file, title;
    bool modified = false;
  };

  /// A job that windows wait for begins. @param what  "open \"x.glb\"".
  virtual void begin(const std::string& what) = 0;
  virtual void end(Job job, bool ok) = 0;
  virtual void tell(const Message& told) = 0;
  /// @param total  0: unknown.
  virtual void show_progress(const std::string& what, int done, int total) = 0;
  virtual void show(State state) = 0;
  virtual void show_modified(bool modified) = 0;
  /// The next state is of another scene. @param next  its number.
  virtual void forget_scene(std::uint64_t next) = 0;
  virtual void show_scene(std::shared_ptr<const SceneSnapshot> snapshot) = 0;
  virtual void show_verdict(std::shared_ptr<const SceneVerdict> verdict) = 0;
  virtual void select_named(const std::vector<std::string>& names) = 0;
  /// @param ms  since its goal was set.
  virtual void show_drag(std::shared_ptr<const SceneSnapshot> snapshot, std::uint64_t drag,
                         double ms) = 0;
  virtual void drag_refused(std::uint64_t drag) = 0;
  virtual void finish_drag(bool committed) = 0;
  virtual void show_ghost(std::uint64_t request, Ghost ghost) = 0;
  virtual void show_ways(const WaysToLie& ways) = 0;
  /// @param json  of the scene's wishes.
  virtual void show_wishes(const std::string& json) = 0;
  virtual void show_layout(std::uint64_t number, std::shared_ptr<const LayoutGhost> layout) = 0;
  virtual void show_layout_progress(std::uint64_t number, const std::string& thing, int done,
                                    int total) = 0;
  virtual void show_zlists(std::shared_ptr<const ZListView> view) = 0;
  virtual void show_moves_by(const Answering& answering) = 0;
  virtual void show_previews_by(const Answering& answering) = 0;
  virtual void show_detection_note(const Sentence& note) = 0;
  /// Looks of a scene that was opened.
  virtual void show_looks(const SceneLooks& looks) = 0;
  /// Looks as the file has them now.
  virtual void show_saved_looks(const SceneLooks& looks) = 0;
  virtual void show_looks_of_step(const Looks& from, const Looks& to) = 0;
  virtual void show_look_step(const History& history, const Selection& before) = 0;
  virtual void show_history(const History& history) = 0;

 protected:
  ~EngineNews() = default;
};

}  // namespace trivet::edit
