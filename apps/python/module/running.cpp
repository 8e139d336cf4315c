#include "apps/python/module/running.h"

#include <pthread.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "core/base/arena.h"

namespace trivet::python {
namespace {

// Guarded by the GIL, except for the atomics.
pthread_t main_thread;
bool is_ending = false;
int num_running = 0;
int forks = 0;
std::atomic<int> num_apart = 0;  // threads of run_apart() that have not ended
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
  while (num_running > 0 || num_apart > 0) {
    const py::gil_scoped_release release;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// Work in a thread of its own.
class ApartWork {
 public:
  explicit ApartWork(std::function<void()> work) : m_work(std::move(work)) {}

  static void start(const std::shared_ptr<ApartWork>& self) {
    ++num_apart;
    try {
      std::thread([self] { in_arena(0, [&] { self->run(); }); }).detach();
    } catch (...) {
      --num_apart;
      throw;
    }
  }
  /// @return true if it has ended, false if it is cancelled before.
  bool wait(const std::atomic<bool>& cancel) {
    constexpr std::chrono::milliseconds kPause(1);
    std::unique_lock lock(m_mutex);
    while (!m_has_ended && !cancel) m_ended.wait_for(lock, kPause);
    return m_has_ended;
  }
  void rethrow() const {
    if (m_thrown) std::rethrow_exception(m_thrown);
  }

 private:
  void run() {
    try {
      m_work();
    } catch (...) {
      m_thrown = std::current_exception();
    }
    m_work = nullptr;
    {
      const std::lock_guard lock(m_mutex);
      m_has_ended = true;
      m_ended.notify_all();
    }
    --num_apart;
  }

  std::function<void()> m_work;
  std::exception_ptr m_thrown;
  std::mutex m_mutex;
  std::condition_variable m_ended;
  bool m_has_ended = false;
};

}  // namespace

void raise_stopped() {
  PyErr_SetString(PyExc_RuntimeError,
                  "stopped before it was done: by a signal whose handler raises nothing, or "
                  "because the interpreter ends");
  throw py::error_already_set();
}

void run_apart(std::shared_ptr<std::atomic<bool>> cancel, std::function<void()> work) {
  const auto apart = std::make_shared<ApartWork>(std::move(work));
  bool has_ended = false;
  {
    const Cancellable cancellable(*cancel);
    has_ended = without_gil([&] {
      ApartWork::start(apart);
      return apart->wait(*cancel);
    });
  }
  if (PyErr_CheckSignals()) throw py::error_already_set();
  if (has_ended) return apart->rethrow();
  raise_stopped();
}

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
    num_apart = 0;
    ++forks;
    cancellable().clear();
  });
  using namespace py::literals;
  py::module_::import("os").attr("register_at_fork")("after_in_child"_a = after_fork);
  py::module_::import("atexit").attr("register")(py::cpp_function(&at_exit));
}

}  // namespace trivet::python
