// Previews operations on a copy of the scene, on a thread of its own; the latest request wins.
// Private.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "apps/edit/document/ghost.h"

namespace trivet::edit {

class GhostWorker {
 public:
  using Answer = std::function<void(std::uint64_t request, Ghost ghost)>;
  /// @param answer  called on the worker's thread; skipped for superseded requests.
  explicit GhostWorker(Answer answer);
  ~GhostWorker();

  /// @param scene  null: that of the last request.
  void request(std::uint64_t number, const Operation& operation, const SettleOptions& options,
               const RunContext& context, std::unique_ptr<Scene> scene);
  bool is_idle() const;

 private:
  struct Request {
    std::uint64_t number = 0;
    Operation operation;
    SettleOptions options;
    RunContext context;
    std::chrono::steady_clock::time_point when;
  };
  void run();
  Ghost answer_to(const Request& request);

  Answer m_answer;
  std::unique_ptr<Scene> m_scene;  // owned by the thread
  std::atomic<bool> m_cancel = false;
  mutable std::mutex m_mutex;  // guards the members below
  std::condition_variable m_wake;
  std::optional<Request> m_next;
  std::unique_ptr<Scene> m_next_scene;
  bool m_works = false, m_stop = false;
  std::thread m_thread;
};

}  // namespace trivet::edit
