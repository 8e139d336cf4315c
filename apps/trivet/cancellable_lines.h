// Lines of standard input, read ahead, so that one of them can cancel those before it.
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
  /// Begins to read, on a thread of its own. @param input  outlives the program.
  /// @param cancels  whether a line cancels all lines before it that are not done; called on that
  ///   thread, and must not throw.
  CancellableLines(std::istream& input, std::function<bool(const std::string&)> cancels);
  ~CancellableLines();
  CancellableLines(const CancellableLines&) = delete;
  CancellableLines& operator=(const CancellableLines&) = delete;

  /// Waits for it. The line before is done. @return null at the end of the input.
  std::shared_ptr<InputLine> next();

 private:
  struct State;
  std::shared_ptr<State> m_state;  // shared with the thread, which nothing can wake from reading
};

}  // namespace trivet::apps
