// Previews operations on a copy of the scene, on a thread of its own with a detector of its own;
// the latest request wins. Also computes what the z-list view shows, at most for a part of the
// time. Private.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "apps/edit/document/ghost.h"
#include "apps/edit/document/thread_detector.h"
#include "apps/edit/document/zlist_view.h"

namespace trivet::edit {

class GhostWorker {
 public:
  /// Called on the worker's thread.
  struct Listener {
    std::function<void(std::uint64_t request, Ghost ghost)> ghost;  // not for superseded ones
    std::function<void(std::shared_ptr<const ZListView> view)> zlists;
    std::function<void(const Answering& answering)> answering;  // another detector answers
    std::function<void()> measured;                             // BackendOptions::machine is
  };
  GhostWorker(BackendOptions detection, Listener listener);
  ~GhostWorker();

  /// Another detector for the next request. A machine is measured first, which takes seconds when
  /// it was never measured before.
  void choose(BackendOptions detection);
  /// @param choices  one at least; the first that is done answers, else the first.
  /// @param scene  null: that of the last request.
  /// @param shown  what windows show of it: the z-lists of the fall of a PUT are computed, too;
  ///   null: they are not.
  void request(std::uint64_t number, std::vector<Operation> choices, const SettleOptions& options,
               const RunContext& context, std::unique_ptr<Scene> scene,
               std::shared_ptr<const SceneSnapshot> shown);
  /// Computes the z-lists of a motion when there is time; of several, the last.
  void watch(ZListQuestion question);
  bool is_idle() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Request {
    std::uint64_t number = 0;
    std::vector<Operation> choices;
    SettleOptions options;
    RunContext context;
    std::shared_ptr<const SceneSnapshot> shown;
    Clock::time_point when;
  };
  enum class Task { Stop, Renew, Ghost, ZLists };
  void run();
  Task next_task(Request& request, ZListQuestion& question);
  void renew();
  void measure();
  Ghost answer_to(const Request& request);
  Ghost answer_to(const Request& request, const Operation& operation);
  std::optional<ZListQuestion> fall_of(const Request& request) const;
  void show_zlists(const ZListQuestion& question);

  Listener m_listener;
  ThreadDetector m_detector;
  Answering m_told;
  std::unique_ptr<Scene> m_scene;  // owned by the thread
  std::atomic<bool> m_cancel = false;
  mutable std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::optional<Request> m_next;
  std::unique_ptr<Scene> m_next_scene;
  std::optional<ZListQuestion> m_question;
  Clock::time_point m_rested = {};     // no z-lists before this
  std::shared_ptr<Machine> m_machine;  // to be measured; null: none
  bool m_renew = true, m_works = false, m_stop = false;
  std::thread m_thread;
};

}  // namespace trivet::edit
