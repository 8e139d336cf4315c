#include "ops/base/interrupt.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace trivet {
namespace {

bool is_set(const std::atomic<bool>* flag) { return flag && flag->load(std::memory_order_relaxed); }

constexpr double kLongestBudget = 1e8;  // seconds; the clock counts nanoseconds

}  // namespace

Interrupt::Interrupt(const RunContext& context)
    : m_cancel(context.cancel), m_budget_s(context.time_budget_s) {
  if (!(m_budget_s > 0)) return;
  const std::chrono::duration<double> budget(std::min(m_budget_s, kLongestBudget));
  m_deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(budget);
}

void Interrupt::call_after(std::chrono::milliseconds time, std::function<void()> call) {
  m_call_time = Clock::now() + time;
  m_call = std::move(call);
}

std::optional<Interrupt::Reason> Interrupt::reason() {
  if (m_reason) return m_reason;
  if (is_set(m_cancel) || is_set(m_unneeded))
    m_reason = Reason::Cancelled;
  else if (m_deadline && Clock::now() >= *m_deadline)
    m_reason = Reason::OutOfTime;
  else if (m_call && Clock::now() >= m_call_time)
    std::exchange(m_call, nullptr)();
  return m_reason;
}

void Interrupt::refuse(const std::string& op, const Named& object, OperationResult& result) const {
  assert(m_reason);
  Refusal why;
  why.objects = {object};
  why.detail = op;
  if (m_reason == Reason::Cancelled) {
    why.cause = Refusal::Cause::Cancelled;
  } else {
    why.cause = Refusal::Cause::OutOfTime;
    why.numbers = {{"seconds", m_budget_s}};
  }
  result.refuse(std::move(why));
  result.status = m_reason == Reason::Cancelled ? OperationResult::Status::Cancelled
                                                : OperationResult::Status::OutOfTime;
}

}  // namespace trivet
