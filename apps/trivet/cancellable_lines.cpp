#include "apps/trivet/cancellable_lines.h"

#include <condition_variable>
#include <csignal>
#include <deque>
#include <iostream>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/error.h"

namespace trivet::apps {
namespace {

// Back pressure: a sender that is further ahead waits.
constexpr std::size_t kMostAhead = 4096;

// The next line; of one that is too long only that. @return false at the end of the input.
bool read_line(std::istream& input, size_t max_bytes, InputLine& line) {
  if (max_bytes == 0) return static_cast<bool>(std::getline(input, line.text));
  int next = input.get();
  if (next == std::istream::traits_type::eof()) return false;
  for (; next != std::istream::traits_type::eof() && next != '\n'; next = input.get()) {
    line.is_too_long = line.is_too_long || line.text.size() >= max_bytes;
    if (!line.is_too_long) line.text.push_back(static_cast<char>(next));
  }
  if (line.is_too_long) line.text = std::string();
  return true;
}

}  // namespace

struct CancellableLines::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::shared_ptr<InputLine>> waiting;
  std::shared_ptr<InputLine> in_work;
  bool ended = false, closed = false;  // closed: no reader is left

  void cancel(const Cancelled& cancelled) {
    for (const auto& line : waiting)
      if (cancelled(line->text)) line->cancelled = true;
    if (in_work && cancelled(in_work->text)) in_work->cancelled = true;
  }

  void add(std::shared_ptr<InputLine> line, const Cancelled& cancelled) {
    std::unique_lock lock(mutex);
    if (cancelled) cancel(cancelled);
    changed.wait(lock, [this] { return waiting.size() < kMostAhead || closed; });
    waiting.push_back(std::move(line));
    changed.notify_all();
  }

  void set(bool State::*what) {
    const std::lock_guard lock(mutex);
    this->*what = true;
    changed.notify_all();
  }
};

CancellableLines::CancellableLines(std::istream& input, Cancels cancels, size_t max_bytes)
    : m_state(std::make_shared<State>()) {
  std::thread([state = m_state, &input, cancels = std::move(cancels), max_bytes] {
    for (auto line = std::make_shared<InputLine>(); read_line(input, max_bytes, *line);
         line = std::make_shared<InputLine>()) {
      const Cancelled cancelled = cancels(line->text);
      state->add(std::move(line), cancelled);
    }
    state->set(&State::ended);
  }).detach();
}

CancellableLines::~CancellableLines() { m_state->set(&State::closed); }

std::shared_ptr<InputLine> CancellableLines::next() {
  State& s = *m_state;
  std::unique_lock lock(s.mutex);
  s.in_work = nullptr;
  s.changed.wait(lock, [&s] { return !s.waiting.empty() || s.ended; });
  if (s.waiting.empty()) return nullptr;
  s.in_work = std::move(s.waiting.front());
  s.waiting.pop_front();
  s.changed.notify_all();
  return s.in_work;
}

void answer_lines(CancellableLines::Cancels cancels, size_t max_bytes,
                  const std::function<std::optional<std::string>(const InputLine&)>& answer,
                  const char* lost) {
  CancellableLines lines(std::cin, std::move(cancels), max_bytes);
  while (const auto line = lines.next()) {
    const bool is_blank =
        !line->is_too_long && line->text.find_first_not_of(" \t\r") == line->text.npos;
    if (is_blank) continue;
    if (const auto text = answer(*line)) write_answer(*text, lost);
  }
}

void write_answer(const std::string& answer, const char* lost) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is an error like others
  std::cout << answer << std::endl;
  if (!std::cout) throw Error(Error::Kind::Environment, lost);
}

}  // namespace trivet::apps
