#include "apps/farm/workers/pool.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/io/sentence_json.h"
#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

[[noreturn]] void fail(const Sentence& what) { throw Error(Error::Kind::Environment, what); }

WorkerNews news_of(const Message& message) {
  WorkerNews news;
  if (message.bytes.size() != sizeof news) fail("unexpected message of a process");
  std::memcpy(&news, message.bytes.data(), sizeof news);
  return news;
}

std::string death_text(int status, bool over_time, const WorkLimits& limits) {
  if (over_time) return "took more than " + short_number(kWallFactor * limits.scene_seconds) + " s";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
    return "needs more than " + short_number(limits.scene_seconds) + " s of CPU time";
  if (WIFSIGNALED(status))
    return "its process was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "its process ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Pool::Pool(const Work& work, const WorkLimits& limits, int num_workers)
    : m_limits(limits),
      m_max_workers(static_cast<size_t>(num_workers)),
      m_most_together(static_cast<size_t>(std::max(1, work.detection.scenes_together))),
      m_zygote(start_zygote(work, m_limits)) {}

Pool::~Pool() {
  for (const Worker& worker : m_workers)
    if (worker.busy()) kill(worker.id, SIGKILL);
  if (!m_ready) kill(m_zygote.id, SIGKILL);
  // Idle workers end when their sockets close, the zygote when all have: so their CPU time counts
  // as this process's.
  m_workers.clear();
  m_zygote.control.reset();
  waitpid(m_zygote.id, nullptr, 0);
}

Message Pool::next_message() {
  auto message = receive_message(m_zygote.control.number());
  if (!message) fail("the process that has read the models has died; is there enough memory?");
  if (message->bytes[0] == 'E')
    throw Error(message->bytes[1] == '2' ? Error::Kind::BadInput : Error::Kind::Environment,
                sentence_from_json(message->bytes.substr(2)));
  return std::move(*message);
}

void Pool::note_death(const WorkerNews& news) {
  const auto has_id = [&](const Worker& worker) { return worker.id == news.id; };
  if (std::any_of(m_workers.begin(), m_workers.end(), has_id)) m_deaths.push_back(news);
}

void Pool::add_worker() {
  if (!send_message(m_zygote.control.number(), "F"))
    fail("the process that has read the models has died; is there enough memory?");
  while (true) {
    Message message = next_message();
    const WorkerNews news = news_of(message);
    if (news.kind == 'D') {
      note_death(news);
      continue;
    }
    if (message.descriptor.number() < 0)
      fail("too many open files; accepted: fewer --jobs, or a larger ulimit -n");
    m_workers.push_back({news.id, std::move(message.descriptor)});
    return;
  }
}

size_t Pool::num_pending() const {
  size_t out = m_waiting.size();
  for (const Worker& worker : m_workers) out += worker.jobs.size();
  return out;
}

bool Pool::give(Worker& worker, const Job& job) {
  const SceneRequest request{job.k, job.alone};
  char bytes[sizeof request];
  std::memcpy(bytes, &request, sizeof bytes);
  if (!send_frame(worker.socket.number(), {bytes, sizeof bytes})) return false;
  worker.jobs.push_back(job);
  // Scenes that are made side by side take their turns.
  worker.jobs.back().deadline =
      Clock::now() +
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
          kWallFactor * m_limits.scene_seconds * static_cast<double>(worker.jobs.size())));
  return true;
}

bool Pool::has_room(const Worker& worker, const Job& job) const {
  if (!worker.busy()) return true;
  return !job.alone && !worker.jobs.front().alone && worker.jobs.size() < m_most_together &&
         worker.num_scenes + static_cast<int>(worker.jobs.size()) < m_limits.recycle;
}

// The one with the fewest scenes; a new one before any has two. Null: all are full.
Pool::Worker* Pool::worker_for(const Job& job) {
  Worker* out = nullptr;
  for (Worker& worker : m_workers)
    if (has_room(worker, job) && (!out || worker.jobs.size() < out->jobs.size())) out = &worker;
  if ((out && !out->busy()) || m_workers.size() >= m_max_workers) return out;
  add_worker();
  return &m_workers.back();
}

void Pool::hand_out() {
  while (!m_waiting.empty()) {
    Worker* const worker = worker_for(m_waiting.front());
    if (!worker) return;
    if (give(*worker, m_waiting.front())) {
      m_waiting.pop_front();
      continue;
    }
    if (worker->busy()) return;  // it has died: bury() sees to its scenes
    // One that died idle is no scene's fault.
    m_workers.erase(m_workers.begin() + (worker - m_workers.data()));
  }
}

int Pool::status_of(pid_t id) {
  while (true) {
    const auto it = std::find_if(m_deaths.begin(), m_deaths.end(),
                                 [&](const WorkerNews& news) { return news.id == id; });
    if (it != m_deaths.end()) {
      const int status = it->status;
      m_deaths.erase(it);
      return status;
    }
    const WorkerNews news = news_of(next_message());
    if (news.kind == 'D') note_death(news);
  }
}

// @param others  were made in the same process: any may be at fault, so that each is made alone.
void Pool::fail_or_retry(Job job, bool others, const WorkerReply& why,
                         std::vector<DoneScene>& done) {
  if (!others) ++job.num_deaths;
  job.alone = true;
  if (others || job.num_deaths <= m_limits.retries)
    m_waiting.push_front(job);
  else
    done.push_back(
        {job.k, {failed_scene_json(job.k, why.error), {}}, why.error.size(), why.notes, why.work});
}

void Pool::bury(size_t index, std::vector<DoneScene>& done) {
  Worker worker = std::move(m_workers[index]);
  kill(worker.id, SIGKILL);  // where its socket is broken and it is not
  // While it is among the workers its death is noted.
  m_workers[index].id = worker.id;
  const int status = status_of(worker.id);
  m_workers.erase(m_workers.begin() + static_cast<long>(index));
  WorkerReply why;
  why.error = death_text(status, worker.over_time, m_limits);
  for (const Job& job : worker.jobs) fail_or_retry(job, worker.jobs.size() > 1, why, done);
}

void Pool::receive(size_t index, std::vector<DoneScene>& done) {
  Worker& worker = m_workers[index];
  const auto bytes = receive_frame(worker.socket.number());
  if (!bytes) return bury(index, done);
  std::optional<WorkerReply> reply = reply_from(*bytes);
  const auto job = std::find_if(worker.jobs.begin(), worker.jobs.end(),
                                [&](const Job& j) { return reply && j.k == reply->k; });
  if (job == worker.jobs.end()) return bury(index, done);  // it gave no scene
  const Job made = *job;
  worker.jobs.erase(job);
  ++worker.num_scenes;
  if (reply->members)
    done.push_back(
        {made.k, std::move(*reply->members), bytes->size(), std::move(reply->notes), reply->work});
  else
    fail_or_retry(made, reply->is_fatal && worker.busy(), *reply, done);
  if (reply->is_fatal) {
    for (const Job& other : worker.jobs) fail_or_retry(other, true, *reply, done);
    worker.jobs.clear();
  }
  if (!worker.busy() && (reply->is_fatal || worker.num_scenes >= m_limits.recycle))
    m_workers.erase(m_workers.begin() + static_cast<long>(index));  // its socket closes
}

void Pool::kill_late() {
  const auto now = Clock::now();
  for (Worker& worker : m_workers) {
    const bool is_late = std::any_of(worker.jobs.begin(), worker.jobs.end(),
                                     [&](const Job& job) { return now > job.deadline; });
    if (!is_late || worker.over_time) continue;
    worker.over_time = true;
    kill(worker.id, SIGKILL);
  }
}

void Pool::read_news() {
  pollfd waiting{m_zygote.control.number(), POLLIN, 0};
  while (poll(&waiting, 1, 0) > 0) {
    const Message message = next_message();
    if (message.bytes == "R") {
      m_ready = true;
      continue;
    }
    const WorkerNews news = news_of(message);
    if (news.kind == 'D') note_death(news);
  }
}

std::vector<DoneScene> Pool::wait(int other, int timeout_ms) {
  if (m_ready) hand_out();
  std::vector<pollfd> waiting;
  waiting.reserve(m_workers.size() + 2);
  for (const Worker& worker : m_workers) waiting.push_back({worker.socket.number(), POLLIN, 0});
  waiting.push_back({m_zygote.control.number(), POLLIN, 0});
  if (other >= 0) waiting.push_back({other, POLLIN, 0});
  poll(waiting.data(), waiting.size(), std::min(timeout_ms, 1000));
  std::vector<DoneScene> done;
  for (size_t i = m_workers.size(); i-- > 0;)  // from the end: some are erased
    if (waiting[i].revents != 0) receive(i, done);
  read_news();
  kill_late();
  return done;
}

}  // namespace trivet::farm
