#include "ops/operations/tries.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "ops/operations/carried_with.h"
#include "ops/operations/container.h"
#include "ops/stability/carried.h"

namespace trivet {
namespace {

constexpr int kTriesToTouch = 3;   // more of them, where it came to rest across a gap
constexpr double kLeastWay = 0.1;  // that leads over a wall, in parts of the object's size
/// Tries that end out of the container, before a second round and second looks: these mostly do so.
constexpr int kMostThatLeave = 1;
/// Work by which starts are tried: the same on every machine and for every backend. It stops few
/// PUTs, as of fine meshes in full boxes, that would go on for seconds.
constexpr double kWorkOfTry = 100;    // for each that was asked for, in first contacts
constexpr double kFacesOfOne = 8192;  // of an object whose first contact is one unit of work
/// Milliseconds an object after which a copy of the scene costs little: it takes a twentieth.
constexpr double kWorthCopy = 0.02;
/// Others may move in the end, from the starts at which the fewest would.
constexpr size_t kSecondLooks = 2;
constexpr Budget kBudgetOfSecondLook{.first_contacts = 500, .while_sinking = 500};

bool may_do_better_nearby(const OperationResult& result) {
  return result.status == OperationResult::Status::Refused &&
         (result.refusal->cause == Refusal::Cause::Topples ||
          result.refusal->cause == Refusal::Cause::Wedged);
}

/// Kinds of rest; the better one is less.
enum class Rest { Touching, AcrossGap, BesideContainer };

// The object came to rest from that start.
Rest rest_from(const Scene& scene, ObjectId id, const Pose& start) {
  const Object& object = scene.at(id);
  const Vec3 from = centre_at(object, start), to = object.centre_of_mass();
  const double size = size_of(object);
  // Over a wall leads a long way only: most objects ask for no container.
  if ((to - from).head<2>().norm() > kLeastWay * size &&
      Container(scene, carried_with(scene, id), from, size).is_behind_wall(to))
    return Rest::BesideContainer;
  return is_carried_across_gap(object) ? Rest::AcrossGap : Rest::Touching;
}

/// The starts after the first.
class Tries {
 public:
  Tries(const Scene& scene, ObjectId id, const PutOperation& o, StartTrials& trials)
      : m_scene(scene), m_id(id), m_operation(o), m_trials(trials) {}

  /// @param first  refused, or taken back: at rest across a gap or beside its container.
  OperationResult go_on(SettledStart settled, OperationResult first, Rest rest, Budget budget) {
    // Such a rest is kept in hand while other starts are tried for a better one.
    if (first.ok())
      keep(std::move(settled), rest, budget);
    else
      note_movers(std::move(settled), first);
    if (rest == Rest::BesideContainer) m_trials.want_all();
    int num_tries = 1, num_left = 0;
    // A second round costs less than to move others from starts of the first one.
    for (int n = 2; n <= kStartsOfTry * m_operation.tries; ++n) {
      if (m_in_hand && gives_up(num_tries)) break;
      if (n > m_operation.tries && num_left > kMostThatLeave) break;
      if (num_tries >= kLeastStarts && is_worked_enough()) break;
      const auto result = try_number(n);
      if (!result) continue;
      const bool is_over = result->ok() || result->status != OperationResult::Status::Refused;
      if (is_over) return *result;
      num_left += result->refusal->cause == Refusal::Cause::LeavesRegion;
      ++num_tries;
    }
    // No try was better than the rest in hand.
    if (m_in_hand) {
      std::vector<SettledStart> in_hand;
      in_hand.push_back(std::move(m_in_hand->settled));
      return *take_first(std::move(in_hand), m_in_hand->budget);
    }
    if (num_left <= kMostThatLeave)
      if (auto result = look_again()) return *result;
    if (num_tries > 1) {
      first.refusal->numbers.push_back({"tries", static_cast<double>(num_tries)});
      first.refusal->numbers.push_back({"within", m_operation.within * size_of(object())});
    }
    return first;
  }

 private:
  // A rest in hand is not worth many tries.
  bool gives_up(int num_tries) {
    return num_tries >= m_operation.tries ||
           (m_in_hand->rest == Rest::AcrossGap && m_in_hand->tries_left-- <= 0);
  }

  // First contacts of large meshes take longer.
  void note_work(const OperationResult& result) {
    const double num_faces = static_cast<double>(object().shape->mesh.triangles.size());
    m_work += static_cast<double>(result.num_queries) * std::sqrt(num_faces / kFacesOfOne);
  }

  // An object that got beside its container may start from everywhere else, whatever that costs.
  bool is_worked_enough() const {
    return m_work > kWorkOfTry * m_operation.tries &&
           !(m_in_hand && m_in_hand->rest == Rest::BesideContainer);
  }

  void note_movers(SettledStart settled, const OperationResult& result) {
    if (may_do_better_nearby(result))
      m_would_move.push_back({result.refusal->objects.size(), std::move(settled)});
  }

  // From where the fewest would move, now that others may.
  std::optional<OperationResult> look_again() {
    std::stable_sort(m_would_move.begin(), m_would_move.end(),
                     [](const auto& a, const auto& b) { return a.num < b.num; });
    std::vector<SettledStart> fewest;
    for (size_t k = 0; k < std::min(kSecondLooks, m_would_move.size()); ++k)
      fewest.push_back(std::move(m_would_move[k].settled));
    return take_first(std::move(fewest), kBudgetOfSecondLook);
  }

  // A rest across a gap is taken at once: no later look would be better.
  std::optional<OperationResult> take_first(std::vector<SettledStart> starts, Budget budget) {
    m_trials.accept_gaps();
    for (StartTrial& trial : m_trials.all(std::move(starts), budget))
      if (trial.is_last()) return taken(trial);
    return std::nullopt;
  }

  const Object& object() const { return m_scene.at(m_id); }

  /// A start from which it topples with others.
  struct WouldMove {
    size_t num;
    SettledStart settled;
  };

  /// A start from which it rests, but less well than it may from another one.
  struct InHand {
    SettledStart settled;
    Rest rest;
    Budget budget;
    int tries_left = kTriesToTouch;
  };

  // A rest across a gap in the container is better than one beside it.
  void keep(SettledStart settled, Rest rest, Budget budget) {
    if (!m_in_hand || rest < m_in_hand->rest)
      m_in_hand = std::make_unique<InHand>(InHand{std::move(settled), rest, budget});
  }

  // @return nothing: blocked everywhere.
  std::optional<OperationResult> try_number(int number) {
    for (StartTrial& trial : m_trials.next(number)) {
      note_work(trial.result);
      if (trial.is_last()) return taken(trial);
      OperationResult result = refusal_of(trial);
      if (trial.across_gap)
        keep(std::move(trial.settled), Rest::AcrossGap, kBudgetToStand);
      else
        note_movers(std::move(trial.settled), result);
      if (!starts_blocked(result)) return result;
    }
    return std::nullopt;
  }

  OperationResult refusal_of(const StartTrial& trial) const {
    if (!trial.result.ok()) return trial.result;
    const Named name = named(m_scene, Support(m_id));
    return refused({trial.leaves ? Refusal::Cause::LeavesRegion : Refusal::Cause::Topples, {name}});
  }

  OperationResult taken(StartTrial& trial) {
    if (!trial.rests()) return trial.result;
    m_trials.take(trial);
    if (trial.settled.start.number > 1) trial.result.tried = trial.settled.start;
    return trial.result;
  }

  const Scene& m_scene;
  const ObjectId m_id;
  const PutOperation& m_operation;
  StartTrials& m_trials;
  std::vector<WouldMove> m_would_move;
  std::unique_ptr<InHand> m_in_hand;
  double m_work = 0;  // of the starts after the first
};

/// The others, which are begun when the first start takes long.
class Others {
 public:
  /// @param transaction, o, put, run  as of StartTrials; `run` is that of the first start, too.
  Others(Transaction& transaction, ObjectId id, const PutOperation& o, const PutSteps& put,
         OperationRun& run)
      : m_transaction(transaction),
        m_id(id),
        m_operation(o),
        m_put(put),
        m_run(run),
        m_began(run.stopwatch.milliseconds()) {
    if (may_begin()) run.interrupt.call_after(kShortPut, [this] { trials().begin(); });
  }
  ~Others() { begin_none(); }
  Others(const Others&) = delete;
  Others& operator=(const Others&) = delete;

  StartTrials& trials() {
    if (!m_trials) m_trials.emplace(m_transaction, m_id, m_operation, m_put, m_run);
    return *m_trials;
  }

  /// Commits the first start, beside others that are begun; then no more are.
  /// @param commit  says whether its changes stay.
  bool commit(const std::function<bool(Transaction&)>& commit) {
    if (!is_worth_copy()) {
      begin_none();
      return commit(m_transaction);
    }
    // Others are tried from the scene as it was.
    Scene copy = m_transaction.scene();
    Transaction on_copy(copy);
    const bool stays = commit(on_copy);
    begin_none();
    if (!stays) return false;
    m_trials.reset();  // stops them
    for (const ObjectId id : on_copy.touched())
      m_transaction.edit(id, [&](Object& object) { object = copy.at(id); });
    return true;
  }

 private:
  bool may_begin() const { return m_put.num_threads > 1; }

  bool is_worth_copy() const {
    const double milliseconds = m_run.stopwatch.milliseconds() - m_began;
    return may_begin() &&
           milliseconds > kWorthCopy * static_cast<double>(m_transaction.scene().num_objects());
  }

  void begin_none() {
    if (may_begin()) m_run.interrupt.call_after({}, nullptr);
  }

  Transaction& m_transaction;
  const ObjectId m_id;
  const PutOperation& m_operation;
  const PutSteps& m_put;
  OperationRun& m_run;
  const double m_began;
  std::optional<StartTrials> m_trials;
};

}  // namespace

OperationResult put_by_tries(Transaction& transaction, ObjectId id, const PutOperation& o,
                             const PutSteps& put, Budget budget, OperationRun& run) {
  Others others(transaction, id, o, put, run);
  SettledStart settled = settle_from(transaction.scene(), o, put, run, {1, 0, 0, o.start});
  OperationResult first;
  Rest rest = Rest::Touching;
  const bool is_done = others.commit([&](Transaction& there) {
    Transaction inner(there);
    first = put.commit(inner, settled.plan, budget, run);
    if (first.ok()) rest = rest_from(inner.scene(), id, o.start);
    if (!first.ok() || rest != Rest::Touching) return false;
    inner.commit();
    return true;
  });
  if (is_done || (!first.ok() && !may_do_better_nearby(first))) return first;
  return Tries(transaction.scene(), id, o, others.trials())
      .go_on(std::move(settled), std::move(first), rest, budget);
}

}  // namespace trivet
