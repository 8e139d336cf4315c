// Sessions of clients by ids that nobody can guess.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace trivet::serve {

struct SessionLimits {
  int max_sessions = 64;
  double idle_seconds = 600;  // a session unused for so long may be closed when room is needed
};

/// 32 hexadecimal digits.
std::string new_session_id();

/// Safe to use from many threads.
/// @tparam Session  has end(), which stops what it does now and later, and idle_seconds().
template <class Session>
class SessionTable {
 public:
  explicit SessionTable(const SessionLimits& limits) : m_limits(limits) {}

  struct Opened {
    std::string id;
    std::shared_ptr<Session> session;
  };
  /// @param make  called unless there are too many. @return nullopt when there are, all in use.
  /// @throws what `make` throws.
  std::optional<Opened> open(const std::function<std::shared_ptr<Session>()>& make) {
    if (!reserve()) return std::nullopt;
    Opened out{new_session_id(), nullptr};
    try {
      out.session = make();
    } catch (...) {
      const std::lock_guard lock(m_mutex);
      --m_reserved;
      throw;
    }
    const std::lock_guard lock(m_mutex);
    --m_reserved;
    m_sessions[out.id] = out.session;
    return out;
  }

  /// @return null: no such session.
  std::shared_ptr<Session> find(const std::string& id) const {
    const std::lock_guard lock(m_mutex);
    const auto found = m_sessions.find(id);
    return found == m_sessions.end() ? nullptr : found->second;
  }

  /// Ends what it does. @return false: no such session.
  bool close(const std::string& id) {
    const std::lock_guard lock(m_mutex);
    const auto found = m_sessions.find(id);
    if (found == m_sessions.end()) return false;
    found->second->end();
    m_sessions.erase(found);
    return true;
  }

  /// Ends all, requests that still wait for a thread included.
  void end_all() {
    const std::lock_guard lock(m_mutex);
    for (const auto& [id, session] : m_sessions) session->end();
  }

  size_t size() const {
    const std::lock_guard lock(m_mutex);
    return m_sessions.size();
  }

 private:
  bool reserve() {
    const std::lock_guard lock(m_mutex);
    const auto full = [&] {
      return m_sessions.size() + m_reserved >= static_cast<size_t>(m_limits.max_sessions);
    };
    if (full()) close_idle();
    if (full()) return false;
    ++m_reserved;
    return true;
  }

  // One that is asked right now is held by its request, too: it is not idle whatever the clock
  // says.
  void close_idle() {
    std::erase_if(m_sessions, [&](const auto& entry) {
      return entry.second.use_count() == 1 && entry.second->idle_seconds() > m_limits.idle_seconds;
    });
  }

  SessionLimits m_limits;
  mutable std::mutex m_mutex;
  std::map<std::string, std::shared_ptr<Session>> m_sessions;
  size_t m_reserved = 0;  // by sessions that are being made
};

}  // namespace trivet::serve
