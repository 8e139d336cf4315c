// Worker processes, from the parent's side: scenes go in, results come out in any order.
#pragma once

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "apps/farm/workers/reply.h"
#include "apps/farm/workers/zygote.h"

namespace trivet::farm {

struct DoneScene {
  std::uint64_t k = 0;
  SceneMembers members;            // of a scene that could not be made: its JSON says why
  size_t num_bytes = 0;            // as they came from its process
  std::vector<std::string> notes;  // on the detectors of its process
  SceneWork work;
};

class Pool {
 public:
  /// Forks the zygote, which begins to read the models.
  Pool(const Work& work, const WorkLimits& limits, int num_workers);
  /// Ends all processes, those that make a scene at once.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// True when all models are read: before it no scene is made.
  bool ready() const { return m_ready; }
  /// Number of scenes that are being made or wait for it.
  size_t num_pending() const;
  void submit(std::uint64_t k) { m_waiting.push_back({k}); }
  /// Waits until there are results, or something to be read from `other` (a descriptor), or the
  /// time is up. Deaths of workers are dealt with: their scenes are tried again, then failed.
  /// @throws Error as the models do, and (Environment) when no process can be started.
  std::vector<DoneScene> wait(int other, int timeout_ms);

 private:
  using Clock = std::chrono::steady_clock;
  struct Job {
    std::uint64_t k = 0;
    int num_deaths = 0;  // of processes that made it alone
    bool alone = false;
    Clock::time_point deadline = {};
  };
  struct Worker {
    pid_t id;
    Descriptor socket;
    bool over_time = false;  // killed for it
    std::vector<Job> jobs = {};
    int num_scenes = 0;

    bool busy() const { return !jobs.empty(); }
  };
  Message next_message();
  void add_worker();
  void note_death(const WorkerNews& news);
  void read_news();
  void hand_out();
  bool has_room(const Worker& worker, const Job& job) const;
  Worker* worker_for(const Job& job);
  bool give(Worker& worker, const Job& job);
  void receive(size_t index, std::vector<DoneScene>& done);
  void bury(size_t index, std::vector<DoneScene>& done);
  int status_of(pid_t id);
  void fail_or_retry(Job job, bool others, const WorkerReply& why, std::vector<DoneScene>& done);
  void kill_late();

  WorkLimits m_limits;
  size_t m_max_workers, m_most_together;  // scenes of a worker
  Zygote m_zygote;
  bool m_ready = false;
  std::vector<Worker> m_workers;
  std::deque<Job> m_waiting;
  std::vector<WorkerNews> m_deaths;  // not looked at yet
};

}  // namespace trivet::farm
