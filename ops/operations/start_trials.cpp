#include "ops/operations/start_trials.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <memory>
#include <system_error>
#include <utility>

#include "core/base/arena.h"
#include "core/base/in_parallel.h"
#include "core/contact/contact_memory.h"
#include "core/motion/motion.h"
#include "ops/operations/carried_with.h"
#include "ops/settle/program_memory.h"
#include "ops/stability/carried.h"

namespace trivet {
namespace {

constexpr double kTurnDeg = 137.5;          // of a start from that before it: the golden angle
constexpr double kWayDeg = 2.1 * kTurnDeg;  // of their shifts
constexpr double kPartsOfShift[] = {1, 0.5, 0.25, 0};  // where the farther ones cannot be taken

// Between half a turn either way.
double wrapped_deg(double deg) { return std::remainder(deg, 360); }

// At most half a turn either way.
Rotation about_vertical(double deg) {
  const Rotation half = Rotation::about_axis(Vec3::UnitZ(), turn_time(deg / 2));
  return (half * half).normalized();
}

bool is_last(const std::vector<StartTrial>& trials) {
  return !trials.empty() && trials.back().is_last();
}

}  // namespace

StartTried start_to_try(const Object& object, const PutOperation& o, int number, double part) {
  StartTried out{number, 0, 0, o.start};
  if (number <= 1) return out;
  // Starts fill the disc evenly: the area within them grows with their number.
  const double n = number - 1, area = std::min(1.0, n / std::max(1, o.tries - 1));
  out.shifted = part * o.within * size_of(object) * std::sqrt(area);
  out.turned_deg = wrapped_deg(n * kTurnDeg);
  // Angles of turns and shifts never repeat each other.
  const Vec3 way = about_vertical(wrapped_deg(n * kWayDeg)).matrix() * Vec3::UnitX();
  out.start.rotation = (about_vertical(out.turned_deg) * o.start.rotation).normalized();
  out.start.translation.setZero();
  // The centre of mass goes to the shifted place, not the model's origin.
  out.start.translation =
      centre_at(object, o.start) + out.shifted * way - centre_at(object, out.start);
  return out;
}

Vec3 centre_at(const Object& object, const Pose& pose) {
  return world_from_object(pose, object.up, object.scale).apply(object.shape->mass.centre);
}

bool starts_blocked(const OperationResult& result) {
  return result.status == OperationResult::Status::Refused &&
         result.refusal->at == Refusal::At::Start;
}

SettledStart settle_from(const Scene& scene, const PutOperation& o, const PutSteps& put,
                         OperationRun& run, const StartTried& start) {
  PutOperation from = o;
  from.start = start.start;
  return {start, put.plan(scene, from, run)};
}

/// Some trials, each by the first of several threads that is free. They stop after the last one
/// that is needed.
class StartTrials::AtOnce {
 public:
  /// @param scene  stays as it is until all work() is done.
  AtOnce(const Scene& scene, const OperationRun& run, size_t count, TryOne try_one)
      : m_scene(scene),
        m_run(run),
        m_try_one(std::move(try_one)),
        m_trials(count),
        m_unneeded(count) {}

  /// Tries those that no thread has begun. Each thread has a copy of the scene, and memory of what
  /// was computed, of its own.
  void work() {
    size_t k = m_num_begun++;
    if (k >= m_trials.size()) return;
    const ContactMemory contacts;
    const ProgramMemory programs;
    Scene copy = m_scene;
    Transaction transaction(copy);
    for (; k < m_trials.size(); k = m_num_begun++) {
      if (m_unneeded[k]) continue;
      OperationRun run = m_run;
      run.interrupt.stop_on(m_unneeded[k]);
      m_trials[k] = m_try_one(k, transaction, run);
      if (is_last(m_trials[k])) stop_from(k + 1);
    }
  }

  void stop_from(size_t k) {
    for (; k < m_unneeded.size(); ++k) m_unneeded[k] = true;
  }

  /// Once all work() is done.
  std::deque<Trials> take_needed() {
    const auto end = std::find(m_unneeded.begin(), m_unneeded.end(), true);
    m_trials.resize(static_cast<size_t>(end - m_unneeded.begin()));
    return std::move(m_trials);
  }

 private:
  const Scene& m_scene;
  const OperationRun m_run;
  const TryOne m_try_one;
  std::deque<Trials> m_trials;
  std::vector<std::atomic<bool>> m_unneeded;
  std::atomic<size_t> m_num_begun = 0;
};

/// Stops and waits at its end.
struct StartTrials::Begun {
  AtOnce trials;
  std::vector<std::future<void>> threads = {};

  Begun(const Scene& scene, const OperationRun& run, size_t count, TryOne try_one)
      : trials(scene, run, count, std::move(try_one)) {}
  ~Begun() { trials.stop_from(0); }
};

StartTrials::~StartTrials() = default;

StartTrials::StartTrials(Transaction& transaction, ObjectId id, const PutOperation& o,
                         const PutSteps& put, OperationRun& run)
    : m_transaction(transaction),
      m_id(id),
      m_operation(o),
      m_put(put),
      m_run(run),
      m_container(transaction.scene(), carried_with(transaction.scene(), id),
                  centre_at(transaction.scene().at(id), o.start),
                  size_of(transaction.scene().at(id))) {}

std::vector<StartTrial> StartTrials::next(int number) {
  if (m_ahead.empty())
    m_ahead = m_begun ? end_begun()
                      : try_each(static_cast<size_t>(num_ahead(number)), from_number(number));
  Trials out = std::move(m_ahead.front());
  m_ahead.pop_front();
  return out;
}

StartTrials::TryOne StartTrials::from_number(int number) const {
  return [this, number](size_t k, Transaction& transaction, OperationRun& run) {
    return try_number(number + static_cast<int>(k), transaction, run);
  };
}

// Threads of the system: those of loops would have the caller wait for its own.
void StartTrials::begin() {
  const size_t count = static_cast<size_t>(num_ahead(2));
  m_begun = std::make_unique<Begun>(m_transaction.scene(), m_run, count, from_number(2));
  const size_t num_threads = std::min(count, static_cast<size_t>(m_put.num_threads) - 1);
  const auto work = [&trials = m_begun->trials] { in_arena(1, [&] { trials.work(); }); };
  try {
    for (size_t k = 0; k < num_threads; ++k)
      m_begun->threads.push_back(std::async(std::launch::async, work));
  } catch (const std::system_error&) {
    // There are no more threads: the caller tries them all in the end.
  }
}

std::deque<StartTrials::Trials> StartTrials::end_begun() {
  m_begun->trials.work();
  for (std::future<void>& thread : m_begun->threads) thread.get();
  const std::unique_ptr<Begun> begun = std::move(m_begun);
  return begun->trials.take_needed();
}

std::vector<StartTrial> StartTrials::all(std::vector<SettledStart> starts, Budget budget) {
  const auto try_one = [&](size_t k, Transaction& transaction, OperationRun& run) {
    Trials one;
    one.push_back(try_from(std::move(starts[k]), budget, transaction, run));
    return one;
  };
  Trials out;
  for (Trials& trials : try_each(starts.size(), try_one)) out.push_back(std::move(trials.front()));
  return out;
}

void StartTrials::take(StartTrial& trial) {
  for (std::pair<ObjectId, Object>& after : trial.after)
    m_transaction.edit(after.first, [&](Object& now) { now = std::move(after.second); });
}

// Twice the threads, as some starts take much longer than others.
int StartTrials::num_ahead(int number) const {
  const bool is_short =
      number <= kLeastStarts && m_run.stopwatch.milliseconds() < kShortPut.count();
  if (m_put.num_threads <= 1 || is_short) return 1;
  // The others may never be tried: where these cost much, and in a second round.
  const int tries = m_operation.tries;
  const bool are_least = number <= kLeastStarts && !m_wants_all;
  const int last = are_least ? kLeastStarts : number <= tries ? tries : kStartsOfTry * tries;
  const int left = last + 1 - number;
  return m_wants_all ? left : std::min(2 * m_put.num_threads, left);
}

// Up to the first that is the last one.
std::deque<StartTrials::Trials> StartTrials::try_each(size_t count, const TryOne& try_one) {
  if (m_put.num_threads > 1 && count > 1) {
    AtOnce trials(m_transaction.scene(), m_run, count, try_one);
    const size_t num_threads = std::min(count, static_cast<size_t>(m_put.num_threads));
    in_arena(m_put.num_threads, [&] { in_parallel(num_threads, [&](size_t) { trials.work(); }); });
    return trials.take_needed();
  }
  std::deque<Trials> out;
  for (size_t k = 0; k < count && !(k > 0 && is_last(out.back())); ++k)
    out.push_back(try_one(k, m_transaction, m_run));
  return out;
}

StartTrials::Trials StartTrials::try_number(int number, Transaction& transaction,
                                            OperationRun& run) const {
  // Plans are those of the scene itself, as they outlive its copies.
  const Scene& scene = m_transaction.scene();
  const Object& object = scene.at(m_id);
  Trials out;
  // A start that is blocked is tried nearer to the first one.
  for (const double part : kPartsOfShift) {
    const StartTried start = start_to_try(object, m_operation, number, part);
    if (!m_container.holds(centre_at(object, start.start))) continue;
    out.push_back(try_from(settle_from(scene, m_operation, m_put, run, start), kBudgetToStand,
                           transaction, run));
    if (!starts_blocked(out.back().result)) break;
  }
  return out;
}

StartTrial StartTrials::try_from(SettledStart settled, Budget budget, Transaction& transaction,
                                 OperationRun& run) const {
  Transaction trial(transaction);
  StartTrial out;
  out.settled = std::move(settled);
  out.result = m_put.commit(trial, out.settled.plan, budget, run);
  if (!out.result.ok()) return out;
  const Object& object = trial.scene().at(m_id);
  // The object may roll out of its container.
  out.leaves = out.settled.start.number > 1 && !m_container.holds(object.centre_of_mass());
  out.across_gap = !out.leaves && !m_accepts_gaps && is_carried_across_gap(object);
  if (out.rests())
    for (const ObjectId id : trial.touched()) out.after.emplace_back(id, trial.scene().at(id));
  return out;
}

}  // namespace trivet
