#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cmath>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <thread>

#include "apps/farm/workers/scene_maker.h"

namespace trivet::farm {
namespace {

/// While it lives: SIGPROF, which ends the process, after this CPU time of this thread.
class CpuLimit {
 public:
  explicit CpuLimit(double seconds) {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGPROF;
    if (timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &m_timer) != 0) return;
    m_is_made = true;
    const double whole = std::floor(seconds);
    itimerspec limit{};
    limit.it_value.tv_sec = static_cast<time_t>(whole);
    limit.it_value.tv_nsec = std::max(1L, static_cast<long>((seconds - whole) * 1e9));
    timer_settime(m_timer, 0, &limit, nullptr);
  }
  ~CpuLimit() {
    if (m_is_made) timer_delete(m_timer);
  }
  CpuLimit(const CpuLimit&) = delete;
  CpuLimit& operator=(const CpuLimit&) = delete;

 private:
  timer_t m_timer{};
  bool m_is_made = false;
};

/// The requests of a socket, answered by as many threads as scenes are made side by side.
class Worker {
 public:
  Worker(SceneMaker& maker, const WorkLimits& limits, int socket)
      : m_maker(maker), m_limits(limits), m_socket(socket) {}

  void answer_here() {
    while (const auto request = next_request()) answer(*request);
  }

  // Threads wait for requests, this one for the socket.
  void answer_in_threads(int num_threads) {
    std::vector<std::thread> threads;
    for (int i = 0; i < num_threads; ++i) threads.emplace_back([this] { answer_waiting(); });
    while (const auto request = next_request()) {
      if (request->alone) {  // nothing else was asked for
        answer(*request);
        continue;
      }
      const std::lock_guard lock(m_mutex);
      m_waiting.push_back(*request);
      m_changed.notify_one();
    }
    {
      const std::lock_guard lock(m_mutex);
      m_has_ended = true;
      m_changed.notify_all();
    }
    for (std::thread& thread : threads) thread.join();
  }

 private:
  std::optional<SceneRequest> next_request() {
    const auto bytes = receive_frame(m_socket);
    if (!bytes) return std::nullopt;
    SceneRequest request;
    if (bytes->size() != sizeof request) _exit(1);
    std::memcpy(&request, bytes->data(), sizeof request);
    return request;
  }

  void answer_waiting() {
    while (true) {
      std::unique_lock lock(m_mutex);
      m_changed.wait(lock, [this] { return m_has_ended || !m_waiting.empty(); });
      if (m_waiting.empty()) return;
      const SceneRequest request = m_waiting.front();
      m_waiting.pop_front();
      lock.unlock();
      answer(request);
    }
  }

  void answer(const SceneRequest& request) {
    std::string reply;
    {
      const CpuLimit limit(m_limits.scene_seconds);
      reply = to_bytes(m_maker.make(request));
    }
    const std::lock_guard lock(m_sending);
    if (!send_frame(m_socket, reply)) _exit(1);
  }

  SceneMaker& m_maker;
  const WorkLimits& m_limits;
  int m_socket;
  std::mutex m_sending, m_mutex;  // the second guards all below
  std::condition_variable m_changed;
  std::deque<SceneRequest> m_waiting;
  bool m_has_ended = false;
};

}  // namespace

void serve_scenes(const Work& work, const LoadedModels& models, const WorkLimits& limits,
                  std::uint64_t worker, int socket) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPROF, SIG_DFL);
  SceneMaker maker(work, models, limits, worker);
  Worker requests(maker, limits, socket);
  if (work.detection.scenes_together > 1)
    requests.answer_in_threads(work.detection.scenes_together);
  else
    requests.answer_here();
  _exit(0);
}

}  // namespace trivet::farm
