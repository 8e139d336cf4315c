#include "apps/farm/batch/batch.h"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <list>
#include <map>

#include "apps/farm/batch/stop_signals.h"
#include "apps/farm/workers/pool.h"

namespace trivet::farm {
namespace {

using Clock = std::chrono::steady_clock;

/// A unit in progress: scenes come in any order, and are written in that of k.
class OpenUnit {
 public:
  OpenUnit(const BatchRun& run, const std::string& batch, const std::string& out,
           std::uint64_t unit)
      : m_number(unit),
        m_next(run.first_scene(unit)),
        m_end(run.end_scene(unit)),
        m_writer(out, unit, run.format, batch) {}

  std::uint64_t number() const { return m_number; }
  bool complete() const { return m_next == m_end; }
  bool has(std::uint64_t k) const { return m_next <= k && k < m_end; }
  void add(DoneScene done) {
    m_early_bytes += done.num_bytes;
    m_early.emplace(done.k, std::move(done));
    for (auto it = m_early.begin(); it != m_early.end() && it->first == m_next;
         it = m_early.erase(it), ++m_next) {
      m_early_bytes -= it->second.num_bytes;
      m_writer.add(it->second.members);
    }
  }
  size_t early_bytes() const { return m_early_bytes; }
  bool publish() { return m_writer.publish(); }

 private:
  std::uint64_t m_number, m_next, m_end;
  std::map<std::uint64_t, DoneScene> m_early;  // done before one ahead of them
  size_t m_early_bytes = 0;
  UnitWriter m_writer;
};

/// @param scene  its JSON, or its row of a manifest.
void count_status(const Json& scene, BatchTotals& totals) {
  const std::string status = scene.at("status");
  const bool before = scene.contains("views");  // what has no pictures for it had failed as a scene
  ++(status == "ok"        ? totals.ok
     : status == "refused" ? totals.refused
     : before              ? totals.failed_before
                           : totals.failed);
}

// "cup" of "cup_12", where that is a group.
GroupTotals* totals_of(const std::string& object, std::map<std::string, GroupTotals>& groups) {
  const auto found = groups.find(object.substr(0, object.rfind('_')));
  return found == groups.end() ? nullptr : &found->second;
}

void count_groups(const Json& scene, std::map<std::string, GroupTotals>& groups) {
  for (const Json& object : scene.at("objects")) {
    GroupTotals* const group = totals_of(object.at("name"), groups);
    if (!group) continue;
    ++group->drawn;
    if (object.at("position").is_null())
      ++group->reasons[object.value("reason", "")];
    else
      ++group->placed;
  }
}

class BatchLoop {
 public:
  BatchLoop(const BatchRun& run, const Work& work, const BatchOptions& options)
      : m_run(run), m_batch(run.id()), m_work(work), m_options(options) {
    if (run.has_scenes())
      for (const RecipeGroup& group : work.recipe.groups) m_totals.groups[group.name];
  }

  BatchTotals run_all();

 private:
  void list_units();
  void count_unit(std::uint64_t unit);
  void make_missing();
  void hand_out(Pool& pool);
  bool open_next_unit();
  size_t early_bytes() const;
  void take(DoneScene done);
  void publish_complete();
  void report_progress();
  std::uint64_t scenes_of(std::uint64_t unit) const {
    return m_run.end_scene(unit) - m_run.first_scene(unit);
  }
  void log(const std::string& line) const {
    if (m_options.log) m_options.log(line);
  }

  const BatchRun& m_run;
  const std::string m_batch;  // which its units name
  const Work& m_work;
  const BatchOptions& m_options;
  std::deque<std::uint64_t> m_missing;
  std::list<OpenUnit> m_open;
  std::uint64_t m_next_scene = 0, m_end_scene = 0;  // of the unit opened last
  std::uint64_t m_num_made = 0, m_num_to_make = 0;
  Clock::time_point m_start = Clock::now(), m_last_log = m_start;
  BatchTotals m_totals;
};

void BatchLoop::list_units() {
  for (std::uint64_t t = m_options.shard.index; t < m_run.num_units(); t += m_options.shard.count) {
    ++m_totals.units;
    if (!unit_exists(m_options.out, t, m_run.format)) {
      if (m_options.is_ready && !m_options.is_ready(t))
        ++m_totals.waiting;
      else
        m_missing.push_back(t), m_num_to_make += scenes_of(t);
      continue;
    }
    ++m_totals.there_before;
    count_unit(t);
  }
}

// One that is there.
void BatchLoop::count_unit(std::uint64_t unit) {
  visit_rows(m_options.out, unit, m_run.format, m_batch,
             [&](const Json& row) { count_status(row, m_totals); });
}

bool BatchLoop::open_next_unit() {
  while (!m_missing.empty()) {
    const std::uint64_t unit = m_missing.front();
    m_missing.pop_front();
    if (unit_exists(m_options.out, unit, m_run.format)) {  // by another copy of this shard
      ++m_totals.by_others;
      m_num_to_make -= scenes_of(unit);
      count_unit(unit);
      continue;
    }
    m_open.emplace_back(m_run, m_batch, m_options.out, unit);
    m_next_scene = m_run.first_scene(unit);
    m_end_scene = m_run.end_scene(unit);
    return true;
  }
  return false;
}

size_t BatchLoop::early_bytes() const {
  size_t sum = 0;
  for (const OpenUnit& unit : m_open) sum += unit.early_bytes();
  return sum;
}

// Enough that no worker waits, until those that are done behind a slow one fill the memory for
// them.
void BatchLoop::hand_out(Pool& pool) {
  constexpr size_t kMaxOpenUnits = 2, kMaxEarlyBytes = size_t{64} << 20;
  const auto most = static_cast<size_t>(m_options.jobs) + 1;
  while (pool.num_pending() < most && early_bytes() < kMaxEarlyBytes) {
    if (m_next_scene == m_end_scene && (m_open.size() >= kMaxOpenUnits || !open_next_unit()))
      return;
    pool.submit(m_next_scene++);
  }
}

void BatchLoop::take(DoneScene done) {
  const Json& scene = done.members.scene;
  const std::uint64_t failed = m_totals.failed;
  count_status(scene, m_totals);
  count_groups(scene, m_totals.groups);
  ++m_num_made;
  if (m_totals.failed > failed)
    log("scene " + std::to_string(done.k) + " failed: " + scene.at("reason").get<std::string>());
  for (OpenUnit& unit : m_open)
    if (unit.has(done.k)) {
      unit.add(std::move(done));
      break;
    }
  report_progress();
}

void BatchLoop::publish_complete() {
  for (auto it = m_open.begin(); it != m_open.end();) {
    if (!it->complete()) {
      ++it;
      continue;
    }
    const bool first = it->publish();
    if (!first) ++m_totals.by_others, ++m_totals.dropped;
    if (!first)
      log("unit " + std::to_string(it->number()) + " was made by another process: dropped");
    it = m_open.erase(it);
  }
}

// After each scene; as lines, not more often than a person reads.
void BatchLoop::report_progress() {
  constexpr std::chrono::seconds kBetweenLines(10);
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> seconds = now - m_start;
  const BatchProgress progress{m_num_made, m_num_to_make,
                               static_cast<double>(m_num_made) / std::max(seconds.count(), 1e-9)};
  if (m_options.on_progress) return m_options.on_progress(progress);
  if (now - m_last_log < kBetweenLines && m_num_made < m_num_to_make) return;
  m_last_log = now;
  log(progress_text(progress));
}

void BatchLoop::make_missing() {
  StopSignals signals;
  Pool pool(m_work, m_options.limits, m_options.jobs);
  while (!pool.ready() && !signals.asked()) {
    pool.wait(signals.descriptor(), 1000);
    signals.look();
  }
  if (!signals.asked() && m_options.on_models_read) m_options.on_models_read();
  m_start = m_last_log = Clock::now();
  while (!signals.at_once()) {
    if (!signals.asked()) hand_out(pool);
    if (pool.num_pending() == 0) break;
    for (DoneScene& done : pool.wait(signals.descriptor(), 1000)) take(std::move(done));
    publish_complete();
    signals.look();
  }
  m_totals.stopped = signals.asked() && !(m_open.empty() && m_missing.empty());
}

BatchTotals BatchLoop::run_all() {
  list_units();
  if (!m_missing.empty()) make_missing();
  return m_totals;
}

}  // namespace

std::string progress_text(const BatchProgress& progress) {
  char text[160];
  const double left = static_cast<double>(progress.total - progress.made);
  std::snprintf(text, sizeof text, "%llu of %llu scenes, %.3g/s, %s left",
                static_cast<unsigned long long>(progress.made),
                static_cast<unsigned long long>(progress.total), progress.scenes_per_second,
                readable_duration(left / std::max(progress.scenes_per_second, 1e-9)).c_str());
  return text;
}

std::string readable_duration(double seconds) {
  char text[64];
  if (seconds < 120)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else if (seconds < 7200)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

BatchTotals run_batch(const BatchRun& run, const Work& work, const BatchOptions& options) {
  return BatchLoop(run, work, options).run_all();
}

bool make_only(const Work& work, const std::vector<std::uint64_t>& ks, int jobs,
               const WorkLimits& limits, const std::function<void(const SceneMembers&)>& take) {
  StopSignals signals;
  Pool pool(work, limits, std::min(jobs, static_cast<int>(ks.size())));
  std::map<std::uint64_t, SceneMembers> early;
  size_t next_in = 0, next_out = 0;
  while (next_out < ks.size()) {
    signals.look();
    if (signals.asked()) return false;
    const size_t most = next_out + 2 * static_cast<size_t>(jobs);  // results wait for their turn
    for (; next_in < ks.size() && next_in < most; ++next_in) pool.submit(ks[next_in]);
    for (DoneScene& done : pool.wait(signals.descriptor(), 1000))
      early[done.k] = std::move(done.members);
    for (; next_out < ks.size() && early.count(ks[next_out]) != 0; ++next_out) {
      take(early[ks[next_out]]);
      early.erase(ks[next_out]);
    }
  }
  return true;
}

}  // namespace trivet::farm
