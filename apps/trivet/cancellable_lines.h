// Lines of standard input, read ahead, so that a line can cancel earlier ones.
#pragma once

#include <atomic>
#include <functional>
#include <istream>
#include <memory>
#include <string>

namespace trivet::apps {

struct InputLine {
  std::string text;
  std::atomic<bool> cancelled = false;  // by a later line
};

class CancellableLines {
 public:
  /// Starts to read, on a thread of its own. @param input  outlives the program.
  /// @param cancels  whether a line cancels all unfinished lines before it; called on that thread,
  ///   and must not throw.
  CancellableLines(std::istream& input, std::function<bool(const std::string&)> cancels);
  ~CancellableLines();
  CancellableLines(const CancellableLines&) = delete;
  CancellableLines& operator=(const CancellableLines&) = delete;

  /// Waits for the next line; the previous one is finished. @return null at the end of the input.
  std::shared_ptr<InputLine> next();

 private:
  struct State;
  std::shared_ptr<State> m_state;  // shared with the thread, which cannot be woken from reading
};

}  // namespace trivet::apps
