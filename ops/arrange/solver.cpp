#include "ops/arrange/solver.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/pattern_put.h"
#include "ops/arrange/place_order.h"

namespace trivet {
namespace {

constexpr int kMostLooksInVain = 36;  // looks ahead to a thing that found no place for it

}  // namespace

Solver::Solver(World& world, std::uint64_t seed, Interrupt& interrupt,
               const ArrangeProgress& progress, ArrangeResult& out)
    : m_world(world),
      m_seed(seed),
      m_interrupt(interrupt),
      m_progress(progress),
      m_out(out),
      m_items(ordered_items(world)) {
  m_placed.assign(m_items.size(), 0);
  m_nogoods.resize(world.things().size());
  m_visits.assign(world.things().size(), 0);
  m_results.resize(world.things().size());
  m_times_refused.assign(m_items.size(), 0);
  m_had_no_place.assign(world.things().size(), 0);
  m_has_stood.assign(world.things().size(), 0);
  m_in_vain.assign(world.things().size(), 0);
}

bool Solver::run() {
  try {
    return place_all();
  } catch (const ArrangeStopped&) {
    stopped();
    return false;
  }
}

bool Solver::place_all() {
  while (true) {
    // Items keep their order: the first that is not placed is next, also after evictions.
    const auto next = std::find(m_placed.begin(), m_placed.end(), 0);
    if (next == m_placed.end()) return true;
    const auto item = static_cast<size_t>(next - m_placed.begin());
    if (stopped()) return false;
    if (m_progress) m_progress(name_of(item), standing(), m_world.things().size());
    m_refused = {};
    const bool done = m_items[item].pattern ? place_pattern(item) : place_thing(item);
    if (done) {
      m_placed[item] = 1;
    } else if (m_out.conflict || m_out.status != ArrangeResult::Status::Done ||
               (!back_off(item) && !forget_nogoods(item))) {
      explain(item);
      return false;
    }
  }
}

void Solver::finish() {
  // Results come in the order in which things were placed; costs are those of the final poses.
  for (const size_t t : m_order)
    m_out.placed.push_back({m_world.things()[t].thing->object, m_results[t]});
  for (const Relation& r : m_world.arrangement().relations) {
    if (r.is_support()) continue;
    std::optional<Outline> b;
    if (!r.b.empty()) b = m_world.outline(r.b);
    const double cost = r.is_of_sight() ? sight_cost({m_world, -1, {}}, r)
                                        : relation_cost(r, m_world.outline(r.a), b ? &*b : nullptr);
    m_out.relations.push_back({in_english(r.text()), r.is_hard(), cost});
  }
}

bool Solver::stopped() {
  const auto reason = m_interrupt.reason();
  if (!reason) return false;
  m_out.status = *reason == Interrupt::Reason::Cancelled ? ArrangeResult::Status::Cancelled
                                                         : ArrangeResult::Status::OutOfTime;
  return true;
}

std::uint64_t Solver::seed_of(size_t thing) const {
  // Each visit of a thing has its own noise, so that it does not fail in the same way again.
  return scrambled(scrambled(m_seed ^ scrambled(thing)) ^
                   static_cast<std::uint64_t>(m_visits[thing]));
}

void Solver::note_placed(size_t thing, OperationResult result) {
  m_results[thing] = std::move(result);
  m_order.push_back(thing);
  m_has_stood[thing] = 1, m_in_vain[thing] = 0;
  // Progress is measured by how many stand; evictions count as vain until that grows.
  if (standing() > m_most_standing)
    m_most_standing = standing(), m_evictions_then = m_num_evictions;
}

bool Solver::has_stood(const std::string& name) const {
  const int t = m_world.thing_of(name);
  return t >= 0 && m_has_stood[t];
}

bool Solver::put(Placer& placer, const PlaceCandidate& candidate, size_t thing, LookAhead looks) {
  OperationResult result;
  ++m_out.num_puts;
  // The trial is undone unless the thing is kept.
  World::Trial trial(m_world);
  auto why = placer.put(candidate, result);
  m_out.put_milliseconds += result.milliseconds;
  if (!why && looks == LookAhead::On) {
    why = leaves_no_room(thing);
    m_left_no_room = why.has_value();
  }
  if (!why) {
    trial.commit();
    note_placed(thing, std::move(result));
    return true;
  }
  ++m_out.num_refused;
  if (m_refused.empty()) m_refused = *why;
  return false;
}

// Looks ahead to what refers to the thing, stands next to it as soon as it stands, and has had no
// place before: it is to have one.
std::optional<Sentence> Solver::leaves_no_room(size_t thing) {
  const auto stands = [&](const std::string& other) {
    return m_world.thing_of(other) < 0 || m_world.stands(other);
  };
  std::vector<size_t> followers;
  for (const size_t r : m_world.things()[thing].relations) {
    const Relation& relation = m_world.arrangement().relations[r];
    const int t = relation.b == name(thing) ? m_world.thing_of(relation.a) : -1;
    if (t >= 0 && relation.is_hard() && m_had_no_place[t] && !m_world.stands(relation.a))
      followers.push_back(static_cast<size_t>(t));
  }
  std::sort(followers.begin(), followers.end());
  followers.erase(std::unique(followers.begin(), followers.end()), followers.end());
  for (const size_t t : followers) {
    // Only followers whose other references all stand can be judged now.
    const auto& relations = m_world.things()[t].relations;
    const bool ready = std::all_of(relations.begin(), relations.end(), [&](size_t r) {
      const Relation& relation = m_world.arrangement().relations[r];
      return relation.a != name(t) || stands(relation.b);
    });
    // A thing that never finds a place is not looked for any more.
    if (!ready || m_in_vain[t] > kMostLooksInVain) continue;
    ++m_in_vain[t];
    if (Placer(m_world, t, seed_of(t)).candidates(Obstacles::All, m_nogoods[t], 1).empty())
      return say("it would leave no room for %1", quoted(name(t)));
    m_in_vain[t] = 0;
  }
  return std::nullopt;
}

bool Solver::place_thing(size_t item) {
  const size_t thing = m_items[item].things.front();
  ++m_visits[thing];
  Placer placer(m_world, thing, seed_of(thing));
  PlaceOrder places(placer, Obstacles::All, m_nogoods[thing]);
  std::optional<PlaceCandidate> without_room;  // the first that was kept but for what follows
  // The best places are tried by PUT one after the other.
  for (size_t k = 0; k < kTrials; ++k) {
    const auto candidate = places.next();
    if (!candidate && k == 0) m_had_no_place[thing] = 1;
    if (!candidate) break;
    if (stopped()) return false;
    m_left_no_room = false;
    if (put(placer, *candidate, thing, LookAhead::On)) return true;
    if (m_left_no_room && !without_room) without_room = candidate;
  }
  // Where none leaves room for what follows, that is no fault of this one.
  return without_room && !stopped() && put(placer, *without_room, thing, LookAhead::Off);
}

bool Solver::place_pattern(size_t item) {
  // A pattern is placed as a whole, or not at all.
  std::vector<PlacedSlot> placed;
  auto conflict = put_pattern(m_world, *m_items[item].pattern, scrambled(m_seed), placed);
  m_out.num_puts += static_cast<int>(placed.size());
  for (const PlacedSlot& slot : placed) m_out.put_milliseconds += slot.result.milliseconds;
  if (stopped()) return false;
  // A pattern that fails after some of its members counts as one refusal; they are taken back.
  if (conflict) {
    m_out.num_refused += placed.empty() ? 0 : 1;
    m_out.conflict = std::move(conflict);
    return false;
  }
  for (PlacedSlot& slot : placed) note_placed(slot.thing, std::move(slot.result));
  return true;
}

void Solver::explain(size_t item) {
  if (m_out.conflict || m_out.status != ArrangeResult::Status::Done) return;
  m_out.conflict = find_conflict(m_world, m_items[item].things.front(), m_refused);
}

}  // namespace trivet
