// Long calls: the GIL is free meanwhile, Ctrl+C stops operations, and the interpreter does not end
// before they have.
//
// Python's own handler of SIGINT only sets a flag that nobody asks while C++ works. Operations of
// the main thread therefore have a handler that sets their cancel flag and hands on to Python's.
// Threads that are daemons would be unwound through C++ when the interpreter ends; at exit their
// operations are cancelled, and waited for.
#pragma once

#include <pybind11/pybind11.h>
#include <signal.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace trivet::python {

namespace py = pybind11;

/// Counts a call that has given the GIL away. Made and ended with the GIL.
/// @throws RuntimeError (Python) when the interpreter is ending, except in the main thread.
class RunningCall {
 public:
  RunningCall();
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

/// Calls f() without the GIL; f touches nothing of Python.
template <class F>
auto without_gil(F&& f) {
  const RunningCall running;
  const py::gil_scoped_release release;
  return std::forward<F>(f)();
}

/// While it lives, `cancel` is set by Ctrl+C (of the main thread) and when the interpreter ends.
/// Made and ended with the GIL.
class Cancellable {
 public:
  /// @throws what Python's handlers of signals throw that came before.
  explicit Cancellable(std::atomic<bool>& cancel);
  ~Cancellable();
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;

 private:
  std::atomic<bool>* m_cancel;
  std::atomic<bool>* m_outer = nullptr;
  bool m_handles_signal = false;
  struct sigaction m_python = {};
};

/// Calls work() in a thread of its own, without the GIL. Ctrl+C sets `cancel` and is raised at
/// once, in however long a step the work is: the rest ends by itself, and the interpreter waits for
/// it.
/// @param work  owns what it touches, `cancel` too, as it may outlive the call; nothing of Python.
/// @throws what work() throws; RuntimeError (Python) when it was stopped otherwise.
void run_apart(std::shared_ptr<std::atomic<bool>> cancel, std::function<void()> work);

/// RuntimeError (Python): a call was cancelled, and no exception says why.
[[noreturn]] void raise_stopped();

/// The same, with what f() gives.
template <class F>
auto apart(const std::shared_ptr<std::atomic<bool>>& cancel, F f) {
  const auto out = std::make_shared<std::optional<decltype(f())>>();
  run_apart(cancel, [f = std::move(f), out] { out->emplace(f()); });
  return std::move(**out);
}

bool in_main_thread();

/// Number of forks by Python between this process and the one that imported the module.
int num_forks();

/// Once, when the module is imported.
void bind_running();

}  // namespace trivet::python
