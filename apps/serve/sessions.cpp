#include "apps/serve/sessions.h"

#include <random>

#include "core/base/hash.h"

namespace trivet::serve {
namespace {

std::string new_id() {
  std::random_device device;
  const auto word = [&] { return std::uint64_t{device()} << 32 | device(); };
  const std::uint64_t first = word(), second = word();
  return hash_text(first) + hash_text(second);
}

}  // namespace

ServedSession::ServedSession(OpenedSession opened, const DialogueOptions& options,
                             DetectorPool& detectors)
    : m_opened(std::move(opened)), m_dialogue(m_opened, options), m_detectors(detectors) {}

std::optional<Dialogue::Answer> ServedSession::ask(const std::string& line) {
  const std::unique_lock lock(m_busy, std::try_to_lock);
  if (!lock) return std::nullopt;
  m_cancelled = false;
  if (m_ended) m_cancelled = true;  // in this order: end() may come at any moment
  const DetectorPool::Loan detector(m_detectors);
  m_dialogue.use(detector.get());
  Dialogue::Answer out = m_dialogue.answer(line, m_cancelled);
  m_dialogue.use(nullptr);
  m_used = Clock::now();
  return out;
}

void ServedSession::end() {
  m_ended = true;
  m_cancelled = true;
}

std::optional<std::string> ServedSession::scene(const std::string& version) {
  const std::unique_lock lock(m_busy, std::try_to_lock);
  if (!lock) return std::nullopt;
  m_used = Clock::now();
  return scene_bytes(m_opened, version);
}

double ServedSession::idle_seconds() const {
  return std::chrono::duration<double>(Clock::now() - m_used.load()).count();
}

ServedSessions::ServedSessions(DialogueOptions options, const SessionLimits& limits,
                               DetectorPool& detectors)
    : m_options(std::move(options)), m_limits(limits), m_detectors(detectors) {}

bool ServedSessions::reserve() {
  const std::lock_guard lock(m_mutex);
  const auto full = [&] {
    return m_sessions.size() + m_reserved >= static_cast<size_t>(m_limits.max_sessions);
  };
  if (full()) close_idle();
  if (full()) return false;
  ++m_reserved;
  return true;
}

std::optional<ServedSessions::Opened> ServedSessions::open(
    const std::function<OpenedSession()>& make) {
  if (!reserve()) return std::nullopt;
  Opened out{new_id(), nullptr};
  try {
    out.session = std::make_shared<ServedSession>(make(), m_options, m_detectors);
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

std::shared_ptr<ServedSession> ServedSessions::find(const std::string& id) const {
  const std::lock_guard lock(m_mutex);
  const auto found = m_sessions.find(id);
  return found == m_sessions.end() ? nullptr : found->second;
}

bool ServedSessions::close(const std::string& id) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_sessions.find(id);
  if (found == m_sessions.end()) return false;
  found->second->end();
  m_sessions.erase(found);
  return true;
}

void ServedSessions::end_all() {
  const std::lock_guard lock(m_mutex);
  for (const auto& [id, session] : m_sessions) session->end();
}

size_t ServedSessions::size() const {
  const std::lock_guard lock(m_mutex);
  return m_sessions.size();
}

// One that is asked right now is held by its request, too: it is not idle whatever the clock says.
void ServedSessions::close_idle() {
  std::erase_if(m_sessions, [&](const auto& entry) {
    return entry.second.use_count() == 1 && entry.second->idle_seconds() > m_limits.idle_seconds;
  });
}

}  // namespace trivet::serve
