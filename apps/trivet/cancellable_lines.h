// Lines of standard input, read ahead, so that a line can cancel earlier ones, and their answers.
#pragma once

#include <atomic>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace trivet::apps {

struct InputLine {
  std::string text;  // empty of one that is too long
  bool is_too_long = false;
  std::atomic<bool> cancelled = false;  // by a later line
};

class CancellableLines {
 public:
  /// True of a line that is to be cancelled.
  using Cancelled = std::function<bool(const std::string& line)>;
  /// Which unfinished lines before it a line cancels; empty: none. Called on another thread, and
  /// must not throw, nor may what it gives.
  using Cancels = std::function<Cancelled(const std::string& line)>;

  /// Starts to read, on a thread of its own. @param input  outlives the program.
  /// @param max_bytes  of a line; 0: any number.
  CancellableLines(std::istream& input, Cancels cancels, size_t max_bytes = 0);
  ~CancellableLines();
  CancellableLines(const CancellableLines&) = delete;
  CancellableLines& operator=(const CancellableLines&) = delete;

  /// Waits for the next line; the previous one is finished. @return null at the end of the input.
  std::shared_ptr<InputLine> next();

 private:
  struct State;
  std::shared_ptr<State> m_state;  // shared with the thread, which cannot be woken from reading
};

/// Answers the lines of standard input on standard output, each by one line, until they end.
/// @param answer  nullopt: the line has none. @param lost  the error where nobody reads the
/// answers.
/// @throws Error (Environment).
void answer_lines(CancellableLines::Cancels cancels, size_t max_bytes,
                  const std::function<std::optional<std::string>(const InputLine&)>& answer,
                  const char* lost);
/// Writes one of them. @throws Error (Environment), as above.
void write_answer(const std::string& answer, const char* lost);

}  // namespace trivet::apps
