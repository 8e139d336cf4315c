// Sessions that a server keeps for its clients.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "apps/serve/session_table.h"
#include "ops/detect/detector_pool.h"
#include "ops/session/dialogue.h"

namespace trivet::serve {

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
class ServedSessions : public SessionTable<ServedSession> {
 public:
  /// @param detectors  outlive it.
  ServedSessions(DialogueOptions options, const SessionLimits& limits, DetectorPool& detectors);

  /// @param make  as of the table.
  std::optional<Opened> open(const std::function<OpenedSession()>& make);

 private:
  DialogueOptions m_options;
  DetectorPool& m_detectors;
};

}  // namespace trivet::serve
