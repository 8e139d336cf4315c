// After all stand: things, or their clusters, are taken out and put where the soft relations cost
// less.
#include <algorithm>

#include "ops/arrange/place_order.h"
#include "ops/arrange/sights.h"
#include "ops/arrange/solver.h"

namespace trivet {
namespace {

constexpr double kWorth = 0.05;      // least cost of a thing's relations for which it is moved
constexpr double kLeastGain = 1e-3;  // of the cost: smaller ones do not count
constexpr size_t kPlacesEach = 2;    // PUTs of a thing that is moved

}  // namespace

double Solver::soft_cost(const Relation& r) const {
  if (r.is_hard()) return 0;
  double cost = 0;
  // Sights need rays in the scene as it is; all else needs outlines.
  if (r.is_of_sight()) {
    cost = sight_cost({m_world, -1, {}, false}, r);
  } else {
    std::optional<Outline> b;
    if (!r.b.empty()) b = m_world.outline(r.b);
    cost = relation_cost(r, m_world.outline(r.a), b ? &*b : nullptr);
  }
  return *r.weight * cost * cost;
}

// Cost of all soft relations. @param of_thing  that part of each thing.
double Solver::soft_cost(std::vector<double>& of_thing) const {
  // Each relation is judged once, then charged to every thing that it names.
  const std::vector<Relation>& relations = m_world.arrangement().relations;
  std::vector<double> costs;
  double out = 0;
  costs.reserve(relations.size());
  for (const Relation& r : relations) {
    costs.push_back(soft_cost(r));
    out += costs.back();
  }
  of_thing.assign(m_world.things().size(), 0);
  for (size_t t = 0; t < of_thing.size(); ++t)
    for (const size_t r : m_world.things()[t].relations) of_thing[t] += costs[r];
  return out;
}

void Solver::improve() {
  std::vector<double> of_thing;
  double cost = soft_cost(of_thing);
  int num_tries = 0;
  for (bool gained = true; gained;) {
    gained = false;
    // The things whose relations cost most are moved first; those that cost little stay.
    std::vector<size_t> order;
    for (size_t t = 0; t < of_thing.size(); ++t)
      if (of_thing[t] > kWorth) order.push_back(t);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t x, size_t y) { return of_thing[x] > of_thing[y]; });
    for (const size_t t : order) {
      if (num_tries++ == m_world.arrangement().max_improvements || m_interrupt.reason()) return;
      if (m_progress) m_progress(name(t), standing(), m_world.things().size());
      // A thing moves with its cluster, or, if that gains nothing, alone.
      const std::vector<size_t> cluster = cluster_of(t);
      const bool moved = (cluster.size() > 1 && move_for_less(t, cluster, of_thing[t], cost)) ||
                         move_for_less(t, {t}, of_thing[t], cost);
      if (!moved) continue;
      ++m_out.num_improvements;
      gained = true;
    }
    soft_cost(of_thing);
  }
}

// With others and what all of them carry, which are put again, too. @param own  cost of its
// relations. @param cost in: of all; out: less.
bool Solver::move_for_less(size_t thing, const std::vector<size_t>& with, double own,
                           double& cost) {
  const std::vector<size_t> items = items_with_loads(with);
  if (has_pattern(items)) return false;
  // The cluster and its loads are taken out, and come back in the order in which they came.
  std::vector<size_t> again;  // in the order in which they came
  std::vector<OperationResult> results;
  for (const size_t t : m_order)
    if (std::count(items.begin(), items.end(),
                   static_cast<size_t>(item_of(m_world, m_items, name(t)))))
      again.push_back(t), results.push_back(m_results[t]);
  const std::vector<size_t> order = m_order;
  const std::vector<char> placed = m_placed;
  {
    World::Trial trial(m_world);
    take_out(items);
    std::vector<double> of_thing;
    // The thing itself has to find a cheaper place; the others any.
    const auto put_again = [&](size_t t) { return put_at_least(t, t == thing ? own : kInfinity); };
    if (std::all_of(again.begin(), again.end(), put_again)) {
      // The gain counts over all relations, as the cluster may cost more elsewhere.
      const double now = soft_cost(of_thing);
      if (now < (1 - kLeastGain) * cost) {
        cost = now;
        m_placed = placed;
        trial.commit();
        return true;
      }
    }
  }
  // A move that gains nothing is undone.
  m_order = order;
  m_placed = placed;
  for (size_t k = 0; k < again.size(); ++k) m_results[again[k]] = std::move(results[k]);
  return false;
}

// At one of the places that cost least. @param most  those that cost as much are left out;
// infinity: at any place, sampled, as what comes along may stand wherever it can.
bool Solver::put_at_least(size_t thing, double most) try {
  const bool is_sampled = !(most < kInfinity);
  Placer placer(m_world, thing, seed_of(thing), is_sampled ? Noise::On : Noise::Off);
  PlaceOrder places(placer, Obstacles::All, m_nogoods[thing]);
  for (size_t k = 0; k < (is_sampled ? kTrials : kPlacesEach); ++k) {
    const auto place = places.next();
    if (!place || m_interrupt.reason() || !(place->energy < most)) return false;
    if (put(placer, *place, thing, LookAhead::Off)) return true;
  }
  return false;
} catch (const ArrangeStopped&) {
  return false;
}

}  // namespace trivet
