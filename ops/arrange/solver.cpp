#include "ops/arrange/solver.h"

#include <algorithm>

#include "ops/arrange/noise.h"
#include "ops/arrange/pattern_put.h"

namespace trivet {

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
}

bool Solver::run() {
  while (true) {
    const auto next = std::find(m_placed.begin(), m_placed.end(), 0);
    if (next == m_placed.end()) return true;
    const auto item = static_cast<size_t>(next - m_placed.begin());
    if (stopped()) return false;
    if (m_progress) m_progress(name_of(item), standing(), m_world.things().size());
    m_refused.clear();
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
  for (const size_t t : m_order)
    m_out.placed.push_back({m_world.things()[t].thing->object, m_results[t]});
  for (const Relation& r : m_world.arrangement().relations) {
    if (r.is_support()) continue;
    std::optional<Outline> b;
    if (!r.b.empty()) b = m_world.outline(r.b);
    m_out.relations.push_back(
        {r.text(), r.is_hard(), relation_cost(r, m_world.outline(r.a), b ? &*b : nullptr)});
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
  return scrambled(scrambled(m_seed ^ scrambled(thing)) ^
                   static_cast<std::uint64_t>(m_visits[thing]));
}

void Solver::note_placed(size_t thing, OperationResult result) {
  m_results[thing] = std::move(result);
  m_order.push_back(thing);
}

bool Solver::put(Placer& placer, const PlaceCandidate& candidate, size_t thing) {
  OperationResult result;
  ++m_out.num_puts;
  const auto why = placer.put(candidate, result);
  if (!why) {
    note_placed(thing, std::move(result));
    return true;
  }
  ++m_out.num_refused;
  if (m_refused.empty()) m_refused = *why;
  return false;
}

bool Solver::place_thing(size_t item) {
  const size_t thing = m_items[item].things.front();
  ++m_visits[thing];
  Placer placer(m_world, thing, seed_of(thing));
  const auto candidates = placer.candidates(Obstacles::All, m_nogoods[thing]);
  for (size_t k = 0; k < std::min(candidates.size(), kTrials); ++k) {
    if (stopped()) return false;
    if (put(placer, candidates[k], thing)) return true;
  }
  return false;
}

bool Solver::place_pattern(size_t item) {
  std::vector<PlacedSlot> placed;
  auto conflict = put_pattern(m_world, *m_items[item].pattern, scrambled(m_seed), placed);
  m_out.num_puts += static_cast<int>(placed.size());
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
