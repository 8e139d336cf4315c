#include "ops/interrupt.h"

#include <algorithm>
#include <cassert>
#include <sstream>

namespace trivet {
namespace {

constexpr double kLongestBudget = 1e8;  // seconds; the clock counts nanoseconds

}  // namespace

Interrupt::Interrupt(const SettleOptions& options)
    : m_cancel(options.cancel), m_budget_s(options.time_budget_s) {
  if (!(m_budget_s > 0)) return;
  const std::chrono::duration<double> budget(std::min(m_budget_s, kLongestBudget));
  m_deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(budget);
}

std::optional<Interrupt::Reason> Interrupt::reason() {
  if (m_reason) return m_reason;
  if (m_cancel && m_cancel->load(std::memory_order_relaxed))
    m_reason = Reason::Cancelled;
  else if (m_deadline && Clock::now() >= *m_deadline)
    m_reason = Reason::OutOfTime;
  return m_reason;
}

void Interrupt::refuse(const std::string& what, OperationResult& result) const {
  assert(m_reason);
  std::ostringstream text;
  text << what;
  if (m_reason == Reason::Cancelled)
    text << " was cancelled";
  else
    text << " did not end within " << m_budget_s << " s";
  result.status = m_reason == Reason::Cancelled ? OperationResult::Status::Cancelled
                                                : OperationResult::Status::OutOfTime;
  result.reason = text.str();
}

}  // namespace trivet
