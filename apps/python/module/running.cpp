#include "apps/python/module/running.h"

#include <pthread.h>

#include <chrono>
#include <set>
#include <thread>

namespace trivet::python {
namespace {

// Guarded by the GIL, except for the atomics.
pthread_t main_thread;
bool is_ending = false;
int num_running = 0;
int forks = 0;
std::set<std::atomic<bool>*>& cancellable() {
  static auto* const flags = new std::set<std::atomic<bool>*>;  // outlives static destructors
  return *flags;
}

// State of the handler of SIGINT: flags to set, and the handler before it.
std::atomic<std::atomic<bool>*> signalled = nullptr;
struct sigaction python_action = {};

void on_interrupt(int signal, siginfo_t* info, void* context) {
  if (std::atomic<bool>* const flag = signalled.load()) flag->store(true);
  if (python_action.sa_flags & SA_SIGINFO)
    python_action.sa_sigaction(signal, info, context);
  else
    python_action.sa_handler(signal);
}

bool is_handled(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) ||
         (action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN);
}

// Cancels what runs in other threads and waits until they are back in Python.
void at_exit() {
  is_ending = true;
  for (std::atomic<bool>* const flag : cancellable()) flag->store(true);
  while (num_running > 0) {
    const py::gil_scoped_release release;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

bool in_main_thread() { return pthread_equal(pthread_self(), main_thread) != 0; }

int num_forks() { return forks; }

RunningCall::RunningCall() {
  if (is_ending && !in_main_thread()) {
    PyErr_SetString(PyExc_RuntimeError, "the interpreter is ending: Trivet starts nothing more");
    throw py::error_already_set();
  }
  ++num_running;
}
RunningCall::~RunningCall() { --num_running; }

Cancellable::Cancellable(std::atomic<bool>& cancel) : m_cancel(&cancel) {
  if (in_main_thread()) {
    struct sigaction now = {};
    sigaction(SIGINT, nullptr, &now);
    if (is_handled(now)) {
      m_handles_signal = true;
      m_outer = signalled.load();
      m_python = now;
      if (!m_outer) python_action = now;  // else this is the handler below already
      signalled.store(m_cancel);
      struct sigaction ours = now;
      ours.sa_flags |= SA_SIGINFO;
      ours.sa_sigaction = on_interrupt;
      sigaction(SIGINT, &ours, nullptr);
    }
    // Signals that came before would stop nothing.
    if (PyErr_CheckSignals()) {
      if (m_handles_signal) {
        sigaction(SIGINT, &m_python, nullptr);
        signalled.store(m_outer);
      }
      throw py::error_already_set();
    }
  }
  cancellable().insert(m_cancel);
}

Cancellable::~Cancellable() {
  cancellable().erase(m_cancel);
  if (!m_handles_signal) return;
  sigaction(SIGINT, &m_python, nullptr);
  signalled.store(m_outer);
}

void bind_running() {
  const py::object threading = py::module_::import("threading");
  main_thread =
      static_cast<pthread_t>(threading.attr("main_thread")().attr("ident").cast<unsigned long>());
  // A forked child has one thread, which is the main one; no other call runs in it.
  const py::cpp_function after_fork([] {
    main_thread = pthread_self();
    num_running = 0;
    ++forks;
    cancellable().clear();
  });
  using namespace py::literals;
  py::module_::import("os").attr("register_at_fork")("after_in_child"_a = after_fork);
  py::module_::import("atexit").attr("register")(py::cpp_function(&at_exit));
}

}  // namespace trivet::python
