#include "apps/farm/workers/zygote.h"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>

#include "core/base/error.h"
#include "core/io/sentence_json.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

void die_with_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it was faster
}

size_t num_threads_of_process() {
  size_t count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator("/proc/self/task")) ++count;
  return count;
}

bool tell(int control, char kind, pid_t id, int status, int descriptor = -1) {
  const WorkerNews news{kind, id, status};
  char bytes[sizeof news];
  std::memcpy(bytes, &news, sizeof news);
  return send_message(control, {bytes, sizeof bytes}, descriptor);
}

/// Its limits: of memory here, of CPU time per scene by serve_scenes().
void limit_worker([[maybe_unused]] const WorkLimits& limits) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto bytes = static_cast<rlim_t>(limits.memory_mb) << 20;
  const rlimit data{bytes, bytes};
  setrlimit(RLIMIT_DATA, &data);  // sanitizers reserve terabytes
#endif
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

class ZygoteProcess {
 public:
  ZygoteProcess(const Work& work, const WorkLimits& limits, int control)
      : m_work(work), m_limits(limits), m_control(control) {}

  [[noreturn]] void run() {
    // The parent decides when to stop, also where an engine sends its signal to all processes.
    signal(SIGTERM, SIG_IGN);
    signal(SIGINT, SIG_IGN);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    if (!read_models()) _exit(1);
    serve();
    while (waitpid(-1, nullptr, 0) > 0) {
    }
    _exit(0);
  }

 private:
  bool read_models() {
    try {
      m_models = load_models(m_work);
      if (num_threads_of_process() != 1)
        throw Error(Error::Kind::Environment, "a library started threads while models were read");
      return send_message(m_control, "R");
    } catch (const Error& e) {
      const char kind = e.kind() == Error::Kind::BadInput ? '2' : '3';
      send_message(m_control, std::string("E") + kind + to_json(e.sentence()));
    } catch (const std::exception& e) {
      send_message(m_control, std::string("E3reading models: ") + e.what());
    }
    return false;
  }

  void serve() {
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    sigprocmask(SIG_BLOCK, &children, nullptr);
    const Descriptor deaths(signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
    while (true) {
      pollfd waiting[2] = {{m_control, POLLIN, 0}, {deaths.number(), POLLIN, 0}};
      if (poll(waiting, 2, -1) < 0 && errno != EINTR) return;
      if (waiting[1].revents != 0) tell_deaths(deaths.number());
      if (waiting[0].revents == 0) continue;
      const auto message = receive_message(m_control);
      if (!message) return;
      if (!start_worker()) return;
    }
  }

  void tell_deaths(int descriptor) {
    signalfd_siginfo unused;
    while (read(descriptor, &unused, sizeof unused) > 0) {
    }
    int status = 0;
    for (pid_t id; (id = waitpid(-1, &status, WNOHANG)) > 0;) tell(m_control, 'D', id, status);
  }

  bool start_worker() {
    SocketPair sockets = socket_pair(SOCK_STREAM);
    const pid_t zygote = getpid();
    const pid_t id = fork();
    if (id == 0) {
      die_with_parent(zygote);
      close(m_control);
      sockets.a.reset();
      limit_worker(m_limits);
      serve_scenes(m_work, m_models, m_limits, m_num_workers, sockets.b.number());
    }
    if (id < 0) {
      send_message(m_control, std::string("E3no process can be started: ") + std::strerror(errno));
      return false;
    }
    ++m_num_workers;
    return tell(m_control, 'W', id, 0, sockets.a.number());
  }

  const Work& m_work;
  const WorkLimits& m_limits;
  int m_control;
  LoadedModels m_models;
  std::uint64_t m_num_workers = 0;  // that were started
};

}  // namespace

Zygote start_zygote(const Work& work, const WorkLimits& limits) {
  SocketPair sockets = socket_pair(SOCK_SEQPACKET);
  const pid_t parent = getpid();
  const pid_t id = fork();
  if (id == 0) {
    die_with_parent(parent);
    sockets.a.reset();
    ZygoteProcess(work, limits, sockets.b.number()).run();
  }
  if (id < 0)
    throw Error(Error::Kind::Environment, "no process can be started: %1", std::strerror(errno));
  return {id, std::move(sockets.a)};
}

}  // namespace trivet::farm
