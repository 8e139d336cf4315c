// Finds arrangements on copies of the scene, on a thread of its own; the latest request wins.
// Private.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "apps/edit/document/layout_ghost.h"
#include "apps/edit/document/thread_detector.h"
#include "apps/edit/document/wishes.h"

namespace trivet::edit {

class ArrangeWorker {
 public:
  struct Request {
    std::uint64_t number = 0, seed = 0, committed = 0;
    Wishes::Part part;
    size_t num_entries = 0;  // of all wishes
    std::unique_ptr<Scene> scene;
    SettleOptions settle;
  };
  /// Called on the worker's thread; not for superseded requests.
  struct Listener {
    std::function<void(std::uint64_t number, LayoutGhost ghost)> found;
    std::function<void(std::uint64_t number, const std::string& thing, size_t done, size_t total)>
        progressed;
  };
  ArrangeWorker(BackendOptions detection, Listener listener);
  ~ArrangeWorker();

  /// Takes effect with the next request.
  void choose(BackendOptions detection) { m_detector.choose(std::move(detection)); }
  /// Not of a number that was cancelled. Numbers grow.
  void request(Request request);
  /// Cancels requests up to this number, also those that are yet to come.
  void cancel(std::uint64_t number);
  bool is_idle() const;

 private:
  void run();
  LayoutGhost answer_to(Request& request);

  Listener m_listener;
  ThreadDetector m_detector;
  std::atomic<bool> m_cancel = false;
  mutable std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::optional<Request> m_next;
  std::optional<std::uint64_t> m_cancelled;
  bool m_works = false, m_stop = false;
  std::thread m_thread;
};

}  // namespace trivet::edit
