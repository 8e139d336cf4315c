#include "apps/serve/sessions.h"

#include <random>

#include "core/base/hash.h"

namespace trivet::serve {
std::string new_session_id() {
  std::random_device device;
  const auto word = [&] { return std::uint64_t{device()} << 32 | device(); };
  const std::uint64_t first = word(), second = word();
  return hash_text(first) + hash_text(second);
}

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
    : SessionTable(limits), m_options(std::move(options)), m_detectors(detectors) {}

std::optional<ServedSessions::Opened> ServedSessions::open(
    const std::function<OpenedSession()>& make) {
  return SessionTable::open(
      [&] { return std::make_shared<ServedSession>(make(), m_options, m_detectors); });
}

}  // namespace trivet::serve
