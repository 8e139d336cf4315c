#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/arrange.h"
#include "ops/arrange/items.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/pattern_put.h"
#include "ops/base/interrupt.h"
#include "ops/operations/moving_group.h"

namespace trivet {
namespace {

constexpr size_t kTrials = 12;          // PUTs of a thing before others have to give way
constexpr size_t kEvictionPlaces = 32;  // places that are looked at for what is in the way
constexpr double kEvictedAgain = 1.5;   // factor of a thing's weight each time
constexpr int kMostTimesRefused = 3;    // that a thing makes others go although it has places
constexpr size_t kMaxNogoods = 64;      // of a thing

class Solver {
 public:
  Solver(World& world, std::uint64_t seed, Interrupt& interrupt, const ArrangeProgress& progress,
         ArrangeResult& out)
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

  /// False: out.conflict says why, or out.status that it was stopped.
  bool run() {
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

  void finish() {
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

 private:
  const std::string& name(size_t thing) const { return m_world.things()[thing].thing->object; }
  std::string name_of(size_t item) const { return name(m_items[item].things.front()); }
  size_t standing() const { return m_order.size(); }

  bool stopped() {
    const auto reason = m_interrupt.reason();
    if (!reason) return false;
    m_out.status = *reason == Interrupt::Reason::Cancelled ? ArrangeResult::Status::Cancelled
                                                           : ArrangeResult::Status::OutOfTime;
    return true;
  }

  std::uint64_t seed_of(size_t thing) const {
    return scrambled(scrambled(m_seed ^ scrambled(thing)) ^
                     static_cast<std::uint64_t>(m_visits[thing]));
  }

  void note_placed(size_t thing, OperationResult result) {
    m_results[thing] = std::move(result);
    m_order.push_back(thing);
  }

  bool put(Placer& placer, const PlaceCandidate& candidate, size_t thing) {
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

  bool place_thing(size_t item) {
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

  bool place_pattern(size_t item) {
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

  // --- when there is no place --------------------------------------------------------------------

  bool back_off(size_t item) {
    if (m_items[item].pattern || m_no_more ||
        m_num_evictions >= m_world.arrangement().max_evictions)
      return false;
    // A thing that does not come to rest where there is room seldom does so elsewhere.
    if (!m_refused.empty() && ++m_times_refused[item] > kMostTimesRefused) return false;
    return evict_blockers(item) || evict_references(item);
  }

  // A thing whose places were given up for others goes back to one, so that the conflict is told of
  // those others: they get no more room.
  bool forget_nogoods(size_t item) {
    if (m_items[item].pattern || m_no_more) return false;
    std::vector<Vec2>& nogoods = m_nogoods[m_items[item].things.front()];
    if (nogoods.empty()) return false;
    m_no_more = true;
    nogoods.clear();
    return true;
  }

  // The thing where it meets all relations and what does not move, at the place where the least is
  // in the way.
  bool evict_blockers(size_t item) {
    const size_t thing = m_items[item].things.front();
    Placer placer(m_world, thing, seed_of(thing));
    auto places = placer.candidates(Obstacles::Immovable, m_nogoods[thing]);
    if (places.size() > kEvictionPlaces) places.resize(kEvictionPlaces);
    struct Choice {
      double weight;
      size_t place;
      std::vector<size_t> items;
    };
    std::vector<Choice> choices;
    for (size_t k = 0; k < places.size(); ++k) {
      if (stopped()) return false;
      Choice choice{places[k].energy, k, items_with_loads(placer.blockers(places[k]))};
      const bool own_support = carries(choice.items, thing);
      if (choice.items.empty() || own_support || has_pattern(choice.items)) continue;
      for (const size_t i : choice.items) choice.weight += m_items[i].weight;
      choices.push_back(std::move(choice));
    }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.weight < b.weight; });
    for (size_t k = 0; k < std::min(choices.size(), kTrials); ++k)
      if (put_instead(placer, places[choices[k].place], thing, choices[k].items, item)) return true;
    return false;
  }

  bool put_instead(Placer& placer, const PlaceCandidate& place, size_t thing,
                   const std::vector<size_t>& items, size_t item) {
    World::Trial trial(m_world);
    const std::vector<size_t> order = m_order;
    const std::vector<char> placed = m_placed;
    take_out(items);
    OperationResult result;
    ++m_out.num_puts;
    if (placer.put(place, result)) {
      ++m_out.num_refused;
      m_order = order;
      m_placed = placed;
      return false;
    }
    trial.commit();
    note_placed(thing, std::move(result));
    m_placed[item] = 1;
    note_evictions(items);
    return true;
  }

  bool has_pattern(const std::vector<size_t>& items) const {
    return std::any_of(items.begin(), items.end(),
                       [&](size_t i) { return m_items[i].pattern != nullptr; });
  }

  bool carries(const std::vector<size_t>& items, size_t thing) const {
    const Relation* support = m_world.support_of(m_world.things()[thing]);
    if (!support) return false;
    const int below = item_of(m_world, m_items, support->b);
    return below >= 0 && std::count(items.begin(), items.end(), static_cast<size_t>(below));
  }

  // What the thing's relations refer to, and its support when there is nothing else: these places
  // are no good.
  bool evict_references(size_t item) {
    const size_t thing = m_items[item].things.front();
    std::vector<size_t> things;
    const auto collect = [&](bool supports) {
      for (const size_t r : m_world.things()[thing].relations) {
        const Relation& relation = m_world.arrangement().relations[r];
        const std::string& other = relation.a == name(thing) ? relation.b : relation.a;
        if (relation.is_support() != supports || (supports && relation.a != name(thing))) continue;
        if (!relation.is_hard()) continue;
        const int t = m_world.thing_of(other);
        if (t >= 0 && m_world.stands(other)) things.push_back(static_cast<size_t>(t));
      }
    };
    collect(false);
    if (things.empty()) collect(true);
    const std::vector<size_t> items = items_with_loads(things);
    if (items.empty() || has_pattern(items)) return false;
    for (const size_t t : things) {
      const Vec3 at = m_world.object(m_world.things()[t]).pose.translation;
      if (m_nogoods[t].size() >= kMaxNogoods) return false;
      m_nogoods[t].push_back(at.head<2>());
    }
    World::Trial trial(m_world);
    take_out(items);
    trial.commit();
    note_evictions(items);
    return true;
  }

  // Items of these things and of all that they carry, each once.
  std::vector<size_t> items_with_loads(const std::vector<size_t>& things) const {
    std::vector<size_t> out;
    for (const size_t t : things)
      for (const ObjectId id : carried_with(m_world.scene(), m_world.things()[t].id)) {
        const int item = item_of(m_world, m_items, m_world.scene().at(id).name);
        if (item >= 0) out.push_back(static_cast<size_t>(item));
      }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  // Last in, first out: loads before what carries them.
  void take_out(const std::vector<size_t>& items) {
    std::vector<size_t> out;
    for (auto it = m_order.rbegin(); it != m_order.rend(); ++it)
      if (std::count(items.begin(), items.end(),
                     static_cast<size_t>(item_of(m_world, m_items, name(*it)))))
        out.push_back(*it);
    for (const size_t t : out) {
      m_world.perform(UnplaceOperation{{name(t)}});
      m_order.erase(std::find(m_order.begin(), m_order.end(), t));
    }
    for (const size_t i : items) m_placed[i] = 0;
  }

  void note_evictions(const std::vector<size_t>& items) {
    for (const size_t i : items) m_items[i].weight *= kEvictedAgain;
    m_num_evictions += static_cast<int>(items.size());
    m_out.num_evictions += static_cast<int>(items.size());
  }

  void explain(size_t item) {
    if (m_out.conflict || m_out.status != ArrangeResult::Status::Done) return;
    m_out.conflict = find_conflict(m_world, m_items[item].things.front(), m_refused);
  }

  World& m_world;
  std::uint64_t m_seed;
  Interrupt& m_interrupt;
  const ArrangeProgress& m_progress;
  ArrangeResult& m_out;
  std::vector<Item> m_items;
  std::vector<char> m_placed;                // #items
  std::vector<size_t> m_order;               // things that stand, as they came
  std::vector<OperationResult> m_results;    // #things
  std::vector<std::vector<Vec2>> m_nogoods;  // #things, positions
  std::vector<int> m_visits;                 // #things
  std::string m_refused;                     // of the first PUT of this item
  std::vector<int> m_times_refused;          // #items: places, but no PUT was kept
  int m_num_evictions = 0;
  bool m_no_more = false;  // nothing is evicted any more
};

}  // namespace

const char* to_string(ArrangeResult::Status status) {
  constexpr const char* kNames[] = {"done", "conflict", "cancelled", "out of time"};
  return kNames[static_cast<int>(status)];
}

std::string ArrangeResult::reason() const {
  switch (status) {
    case Status::Done:
      return "";
    case Status::Conflict:
      return conflict ? conflict->text : "";
    case Status::Cancelled:
      return "the arrangement was cancelled";
    case Status::OutOfTime:
      break;
  }
  return "the arrangement did not end in time";
}

ArrangeResult arrange(Scene& scene, const Arrangement& arrangement, const SettleOptions& options,
                      const RunContext& context, const ArrangeProgress& progress) {
  ArrangeResult out;
  Interrupt interrupt(context);
  RunContext each = context;
  each.time_budget_s = 0;  // of the whole, not of each PUT
  Transaction transaction(scene);
  for (int attempt = 0; attempt < std::max(1, arrangement.max_attempts); ++attempt) {
    Transaction trial(transaction);
    World world(trial, arrangement, {options, each});
    out.conflict.reset();
    ++out.num_attempts;
    const std::uint64_t seed = scrambled(arrangement.seed ^ scrambled(attempt));
    Solver solver(world, seed, interrupt, progress, out);
    if (solver.run()) {
      solver.finish();
      trial.commit();
      transaction.commit();
      return out;
    }
    if (out.status != ArrangeResult::Status::Done) return out;
  }
  out.status = ArrangeResult::Status::Conflict;
  return out;
}

}  // namespace trivet
