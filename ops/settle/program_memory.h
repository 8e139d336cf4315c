// Solutions of linear programs that were solved before. Private.
#pragma once

#include <string>
#include <unordered_map>

#include "ops/settle/linear_program.h"

namespace trivet {

/// While one lives, LinearProgram remembers its answers on this thread: whoever puts objects down
/// asks for the same forces again, at the trial and at the commit, and of all that stayed where it
/// was. Questions hold every number of a program, so that nothing but time depends on what is
/// remembered. Of several the first one that lives remembers, for all, as ContactMemory does.
class ProgramMemory {
 public:
  using Answer = LinearProgram::Answer;

  /// @param most_bytes  of questions and answers, about.
  explicit ProgramMemory(size_t most_bytes = kMostBytes);
  ~ProgramMemory();
  ProgramMemory(const ProgramMemory&) = delete;
  ProgramMemory& operator=(const ProgramMemory&) = delete;

  /// The first one that lives on this thread, or null.
  static ProgramMemory* current();

  /// @return null: not known; else valid until the next call.
  const Answer* find(const std::string& question);
  void remember(std::string question, Answer answer);
  size_t num_remembered() const { return m_recent.size() + m_older.size(); }

 private:
  static constexpr size_t kMostBytes = 8'000'000;  // of a scene like BREAKFAST: about all

  std::unordered_map<std::string, Answer> m_recent, m_older;
  size_t m_most_bytes, m_bytes = 0;  // of the recent ones
};

}  // namespace trivet
