#include "ops/operations/tries.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "core/motion/motion.h"
#include "ops/operations/carried_with.h"
#include "ops/operations/container.h"
#include "ops/stability/carried.h"

namespace trivet {
namespace {

constexpr double kTurnDeg = 137.5;          // of a start from that before it: the golden angle
constexpr double kWayDeg = 2.1 * kTurnDeg;  // of their shifts
constexpr double kPartsOfShift[] = {1, 0.5, 0.25, 0};  // where the farther ones cannot be taken
constexpr int kTriesToTouch = 3;   // more of them, where it came to rest across a gap
constexpr double kLeastWay = 0.1;  // that leads over a wall, in parts of the object's size
constexpr int kStartsOfTry = 2;    // looked at for each try: some interpenetrate, most topple
constexpr int kMostThatLeave = 1;  // tries that end out of the container, before a second round
/// Work by which starts are tried: the same on every machine and for every backend. It stops few
/// PUTs, as of fine meshes in full boxes, that would go on for seconds.
constexpr double kWorkOfTry = 100;    // for each that was asked for, in first contacts
constexpr double kFacesOfOne = 8192;  // of an object whose first contact is one unit of work
constexpr int kLeastStarts = 3;       // whatever they cost
/// From other starts the whole has to stand at once. A fifth of them do, which costs a fifth of
/// what moving others does to place as many.
constexpr Budget kBudgetToStand{40, 0};
/// Others may move in the end, from the starts at which the fewest would.
constexpr size_t kSecondLooks = 2;
constexpr Budget kBudgetOfSecondLook{600};

// Between half a turn either way.
double wrapped_deg(double deg) { return std::remainder(deg, 360); }

// At most half a turn either way.
Rotation about_vertical(double deg) {
  const Rotation half = Rotation::about_axis(Vec3::UnitZ(), turn_time(deg / 2));
  return (half * half).normalized();
}

Vec3 centre_at(const Object& object, const Pose& pose) {
  return world_from_object(pose, object.up, object.scale).apply(object.shape->mass.centre);
}

bool may_do_better_nearby(const OperationResult& result) {
  return result.status == OperationResult::Status::Refused &&
         (result.refusal->cause == Refusal::Cause::Topples ||
          result.refusal->cause == Refusal::Cause::Wedged);
}

bool starts_blocked(const OperationResult& result) {
  return result.status == OperationResult::Status::Refused &&
         result.refusal->at == Refusal::At::Start;
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

/// A start with the place where the object settles from it, which no budget changes.
struct Settled {
  StartTried start;
  MovePlan plan;
};

Settled settle_from(const Scene& scene, const PutOperation& o, const PutSteps& put,
                    const StartTried& start) {
  PutOperation from = o;
  from.start = start.start;
  return {start, put.plan(scene, from)};
}

/// The starts after the first.
class Tries {
 public:
  Tries(Transaction& transaction, ObjectId id, const PutOperation& o, const PutSteps& put)
      : m_transaction(transaction),
        m_id(id),
        m_operation(o),
        m_put(put),
        m_container(transaction.scene(), carried_with(transaction.scene(), id), centre(o.start),
                    size_of(object())) {}

  /// @param first  refused, or taken back: at rest across a gap or beside its container.
  OperationResult go_on(Settled settled, OperationResult first, Rest rest, Budget budget) {
    // Such a rest is kept in hand while other starts are tried for a better one.
    if (first.ok())
      keep(std::move(settled), rest, budget);
    else
      note_movers(std::move(settled), first);
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
    if (m_in_hand) return take_what_is_in_hand();
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

  void note_movers(Settled settled, const OperationResult& result) {
    if (may_do_better_nearby(result))
      m_would_move.push_back({result.refusal->objects.size(), std::move(settled)});
  }

  // From where the fewest would move, now that others may.
  std::optional<OperationResult> look_again() {
    std::stable_sort(m_would_move.begin(), m_would_move.end(),
                     [](const auto& a, const auto& b) { return a.num < b.num; });
    // Looks note their starts again, so that the list is taken first.
    std::vector<WouldMove> fewest = std::exchange(m_would_move, {});
    // A rest across a gap is taken at once: no later look would be better.
    m_accepts_gap = true;
    for (size_t k = 0; k < std::min(kSecondLooks, fewest.size()); ++k) {
      OperationResult result = commit(std::move(fewest[k].settled), kBudgetOfSecondLook);
      if (result.ok() || result.status != OperationResult::Status::Refused) return result;
    }
    return std::nullopt;
  }

  const Object& object() const { return m_transaction.scene().at(m_id); }
  Vec3 centre(const Pose& pose) const { return centre_at(object(), pose); }

  /// A start from which it topples with others.
  struct WouldMove {
    size_t num;
    Settled settled;
  };

  /// A start from which it rests, but less well than it may from another one.
  struct InHand {
    Settled settled;
    Rest rest;
    Budget budget;
    int tries_left = kTriesToTouch;
  };

  // A rest across a gap in the container is better than one beside it.
  void keep(Settled settled, Rest rest, Budget budget) {
    if (!m_in_hand || rest < m_in_hand->rest)
      m_in_hand = std::make_unique<InHand>(InHand{std::move(settled), rest, budget});
  }

  OperationResult take_what_is_in_hand() {
    m_accepts_gap = true;
    return commit(std::move(m_in_hand->settled), m_in_hand->budget);
  }

  // As far from the first start as it is free and in the container. @return nothing: nowhere.
  std::optional<OperationResult> try_number(int number) {
    // A start that is blocked is tried nearer to the first one.
    for (const double part : kPartsOfShift) {
      const StartTried start = start_to_try(object(), m_operation, number, part);
      if (!m_container.holds(centre(start.start))) continue;
      OperationResult result =
          commit(settle_from(m_transaction.scene(), m_operation, m_put, start), kBudgetToStand);
      if (!starts_blocked(result)) return result;
    }
    return std::nullopt;
  }

  OperationResult commit(Settled settled, Budget budget) {
    const int number = settled.start.number;
    // Each try has a transaction of its own, and leaves no trace unless it is taken.
    Transaction inner(m_transaction);
    OperationResult result = m_put.commit(inner, settled.plan, budget);
    note_work(result);
    if (!result.ok()) {
      note_movers(std::move(settled), result);
      return result;
    }
    // The object may roll out of its container: then the try fails.
    const Object& object = inner.scene().at(m_id);
    const Named name = named(inner.scene(), Support(m_id));
    if (number > 1 && !m_container.holds(object.centre_of_mass()))
      return refused({Refusal::Cause::LeavesRegion, {name}});
    if (!m_accepts_gap && is_carried_across_gap(object)) {
      keep(std::move(settled), Rest::AcrossGap, budget);
      return refused({Refusal::Cause::Topples, {name}});
    }
    if (number > 1) result.tried = settled.start;
    inner.commit();
    return result;
  }

  Transaction& m_transaction;
  const ObjectId m_id;
  const PutOperation& m_operation;
  const PutSteps& m_put;
  const Container m_container;
  std::vector<WouldMove> m_would_move;
  std::unique_ptr<InHand> m_in_hand;
  bool m_accepts_gap = false;
  double m_work = 0;  // of the starts after the first
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

OperationResult put_by_tries(Transaction& transaction, ObjectId id, const PutOperation& o,
                             const PutSteps& put, Budget budget) {
  Settled settled = settle_from(transaction.scene(), o, put, {1, 0, 0, o.start});
  OperationResult first;
  Rest rest = Rest::Touching;
  {
    Transaction inner(transaction);
    first = put.commit(inner, settled.plan, budget);
    if (!first.ok() && !may_do_better_nearby(first)) return first;
    if (first.ok()) rest = rest_from(inner.scene(), id, o.start);
    if (first.ok() && rest == Rest::Touching) {
      inner.commit();
      return first;
    }
  }
  return Tries(transaction, id, o, put).go_on(std::move(settled), std::move(first), rest, budget);
}

}  // namespace trivet
