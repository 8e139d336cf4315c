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
      m_zygote(start_zygote(work, m_limits)) {}

Pool::~Pool() {
  for (const Worker& worker : m_workers)
    if (worker.busy) kill(worker.id, SIGKILL);
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
    Worker worker{news.id, std::move(message.descriptor), false, false, {}, {}, 0};
    m_workers.push_back(std::move(worker));
    return;
  }
}

size_t Pool::num_pending() const {
  const auto is_busy = [](const Worker& worker) { return worker.busy; };
  return m_waiting.size() +
         static_cast<size_t>(std::count_if(m_workers.begin(), m_workers.end(), is_busy));
}

bool Pool::give(Worker& worker, const Job& job) {
  char bytes[sizeof job.k];
  std::memcpy(bytes, &job.k, sizeof bytes);
  if (!send_frame(worker.socket.number(), {bytes, sizeof bytes})) return false;
  worker.busy = true;
  worker.job = job;
  worker.deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(kWallFactor * m_limits.scene_seconds));
  return true;
}

void Pool::hand_out() {
  for (size_t i = 0; i < m_workers.size() && !m_waiting.empty(); ++i) {
    if (m_workers[i].busy) continue;
    // One that died idle is no scene's fault.
    if (give(m_workers[i], m_waiting.front()))
      m_waiting.pop_front();
    else
      m_workers.erase(m_workers.begin() + static_cast<long>(i--));
  }
  while (!m_waiting.empty() && m_workers.size() < m_max_workers) {
    add_worker();
    if (!give(m_workers.back(), m_waiting.front()))
      m_workers.pop_back();
    else
      m_waiting.pop_front();
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

void Pool::fail_or_retry(Job job, const std::string& why, std::vector<DoneScene>& done) {
  if (job.num_deaths++ < m_limits.retries)
    m_waiting.push_front(job);
  else
    done.push_back({job.k, {failed_scene_json(job.k, why), {}}, why.size()});
}

void Pool::bury(size_t index, std::vector<DoneScene>& done) {
  Worker worker = std::move(m_workers[index]);
  kill(worker.id, SIGKILL);  // where its socket is broken and it is not
  // While it is among the workers its death is noted.
  m_workers[index].id = worker.id;
  const int status = status_of(worker.id);
  m_workers.erase(m_workers.begin() + static_cast<long>(index));
  if (worker.busy) fail_or_retry(worker.job, death_text(status, worker.over_time, m_limits), done);
}

void Pool::receive(size_t index, std::vector<DoneScene>& done) {
  Worker& worker = m_workers[index];
  const auto reply = receive_frame(worker.socket.number());
  if (!reply) return bury(index, done);
  nlohmann::json json = nlohmann::json::from_cbor(*reply, true, false);
  worker.busy = false;
  ++worker.num_scenes;
  const Job job = worker.job;
  bool last = worker.num_scenes >= m_limits.recycle;
  if (json.is_object() && json.contains("scene")) {
    DoneScene out{
        job.k, {Json::parse(json["scene"].get_ref<const std::string&>()), {}}, reply->size()};
    for (const nlohmann::json& member : json["more"]) {
      const auto& bytes = member[1].get_binary();
      out.members.more.push_back({member[0].get<std::string>(), {bytes.begin(), bytes.end()}});
    }
    done.push_back(std::move(out));
  } else if (json.is_object() && json.contains("error")) {
    last = last || json["fatal"].get<bool>();
    fail_or_retry(job, json["error"].get<std::string>(), done);
  } else {
    last = true;
    fail_or_retry(job, "its process gave no scene", done);
  }
  if (last) m_workers.erase(m_workers.begin() + static_cast<long>(index));  // its socket closes
}

void Pool::kill_late() {
  for (Worker& worker : m_workers)
    if (worker.busy && !worker.over_time && Clock::now() > worker.deadline) {
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
