#include "ops/operations/start_trials.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
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
constexpr double kShort = 50;  // milliseconds in which most PUTs are done; no result depends on it
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

/// Which trials at once are not needed any more: those after one that is the last.
class Unneeded {
 public:
  explicit Unneeded(size_t count) : m_flags(count) {}

  const std::atomic<bool>& flag(size_t k) const { return m_flags[k]; }
  bool is(size_t k) const { return m_flags[k]; }
  void after(size_t k) {
    for (++k; k < m_flags.size(); ++k) m_flags[k] = true;
  }
  /// When all have ended.
  size_t num_needed() const {
    return static_cast<size_t>(std::find(m_flags.begin(), m_flags.end(), true) - m_flags.begin());
  }

 private:
  std::vector<std::atomic<bool>> m_flags;
};

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
    m_ahead = try_each(static_cast<size_t>(num_ahead(number)),
                       [&](size_t k, Transaction& transaction, OperationRun& run) {
                         return try_number(number + static_cast<int>(k), transaction, run);
                       });
  Trials out = std::move(m_ahead.front());
  m_ahead.pop_front();
  return out;
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
  const bool is_short = number <= kLeastStarts && m_run.stopwatch.milliseconds() < kShort;
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
  if (m_put.num_threads > 1 && count > 1) return try_at_once(count, try_one);
  std::deque<Trials> out;
  for (size_t k = 0; k < count && !(k > 0 && is_last(out.back())); ++k)
    out.push_back(try_one(k, m_transaction, m_run));
  return out;
}

// Each thread has its own copy of the scene, and memory of what was computed.
std::deque<StartTrials::Trials> StartTrials::try_at_once(size_t count, const TryOne& try_one) {
  std::deque<Trials> out(count);
  std::atomic<size_t> num_begun = 0;
  Unneeded unneeded(count);
  const auto try_some = [&](size_t) {
    size_t k = num_begun++;
    if (k >= count) return;
    const ContactMemory contacts;
    const ProgramMemory programs;
    Scene copy = m_transaction.scene();
    Transaction transaction(copy);
    for (; k < count; k = num_begun++) {
      if (unneeded.is(k)) continue;
      OperationRun run = m_run;
      run.interrupt.stop_on(unneeded.flag(k));
      out[k] = try_one(k, transaction, run);
      if (is_last(out[k])) unneeded.after(k);
    }
  };
  const size_t num_threads = std::min(count, static_cast<size_t>(m_put.num_threads));
  in_arena(m_put.num_threads, [&] { in_parallel(num_threads, try_some); });
  out.resize(unneeded.num_needed());
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
