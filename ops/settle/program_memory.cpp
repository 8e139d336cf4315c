#include "ops/settle/program_memory.h"

#include <utility>

namespace trivet {
namespace {

thread_local ProgramMemory* first_living = nullptr;

}  // namespace

ProgramMemory::ProgramMemory(size_t most_bytes) : m_most_bytes(most_bytes) {
  if (!first_living) first_living = this;
}

ProgramMemory::~ProgramMemory() {
  if (first_living == this) first_living = nullptr;
}

ProgramMemory* ProgramMemory::current() { return first_living; }

const ProgramMemory::Answer* ProgramMemory::find(const std::string& question) {
  // Answers that are still asked for are found in either half; only new ones are counted.
  if (const auto known = m_recent.find(question); known != m_recent.end()) return &known->second;
  const auto older = m_older.find(question);
  return older == m_older.end() ? nullptr : &older->second;
}

// The older half is forgotten when the recent half is full.
void ProgramMemory::remember(std::string question, Answer answer) {
  m_bytes += question.size() + answer.basis.size() +
             (answer.solution.x.size() + answer.solution.prices.size()) * sizeof(double);
  m_recent.insert_or_assign(std::move(question), std::move(answer));
  if (m_bytes < m_most_bytes / 2) return;
  m_older = std::exchange(m_recent, {});
  m_bytes = 0;
}

}  // namespace trivet
