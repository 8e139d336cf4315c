#include "apps/trivet/cancellable_lines.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace trivet::apps {
namespace {

// Back pressure: a sender that is further ahead waits.
constexpr std::size_t kMostAhead = 4096;

}  // namespace

struct CancellableLines::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::shared_ptr<InputLine>> waiting;
  std::shared_ptr<InputLine> in_work;
  bool ended = false, closed = false;  // closed: no reader is left

  void cancel_all() {
    for (const auto& line : waiting) line->cancelled = true;
    if (in_work) in_work->cancelled = true;
  }

  void add(std::string text, bool cancels) {
    auto line = std::make_shared<InputLine>();
    line->text = std::move(text);
    std::unique_lock lock(mutex);
    if (cancels) cancel_all();
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

CancellableLines::CancellableLines(std::istream& input,
                                   std::function<bool(const std::string&)> cancels)
    : m_state(std::make_shared<State>()) {
  std::thread([state = m_state, &input, cancels = std::move(cancels)] {
    for (std::string text; std::getline(input, text);) {
      const bool is_cancel = cancels(text);
      state->add(std::move(text), is_cancel);
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

}  // namespace trivet::apps
