// Sessions that a server keeps for its clients.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "ops/detect/detector_pool.h"
#include "ops/session/dialogue.h"

namespace trivet::serve {

struct SessionLimits {
  int max_sessions = 64;
  double idle_seconds = 600;  // a session unused for so long may be closed when room is needed
};

/// One client's session. One thread at a time asks it; any may cancel.
class ServedSession {
 public:
  /// @param detectors  outlive it.
  ServedSession(OpenedSession opened, const DialogueOptions& options, DetectorPool& detectors);

  /// @return nullopt while another request is under way.
  std::optional<Dialogue::Answer> ask(const std::string& line);
  std::optional<std::string> scene(const std::string& version);
  Dialogue::Answer greeting() const { return m_dialogue.greeting(); }
  /// Stops the operation that is under way.
  void cancel() { m_cancelled = true; }
  /// Stops it, and all operations that are asked for later.
  void end();
  double idle_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  OpenedSession m_opened;
  Dialogue m_dialogue;
  DetectorPool& m_detectors;
  std::mutex m_busy;
  std::atomic<bool> m_cancelled = false, m_ended = false;
  std::atomic<Clock::time_point> m_used = Clock::now();
};

/// Safe to use from many threads.
class ServedSessions {
 public:
  /// @param detectors  outlive it.
  ServedSessions(DialogueOptions options, const SessionLimits& limits, DetectorPool& detectors);

  struct Opened {
    std::string id;  // 32 hexadecimal digits that nobody can guess
    std::shared_ptr<ServedSession> session;
  };
  /// @param make  called unless there are too many. @return nullopt when there are, all in use.
  /// @throws what `make` throws.
  std::optional<Opened> open(const std::function<OpenedSession()>& make);
  /// @return null: no such session.
  std::shared_ptr<ServedSession> find(const std::string& id) const;
  /// Ends what it does. @return false: no such session.
  bool close(const std::string& id);
  /// Ends all, requests that still wait for a thread included.
  void end_all();
  size_t size() const;

 private:
  bool reserve();
  void close_idle();

  DialogueOptions m_options;
  SessionLimits m_limits;
  DetectorPool& m_detectors;
  mutable std::mutex m_mutex;
  std::map<std::string, std::shared_ptr<ServedSession>> m_sessions;
  size_t m_reserved = 0;  // by sessions that are being made
};

}  // namespace trivet::serve
