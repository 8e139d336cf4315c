// No place for a thing: what is in the way goes, or what its relations refer to.
#include <algorithm>

#include "ops/arrange/solver.h"
#include "ops/operations/carried_with.h"

namespace trivet {
namespace {

constexpr size_t kEvictionPlaces = 32;  // places that are looked at for what is in the way
constexpr double kEvictedAgain = 1.5;   // factor of a thing's weight each time
constexpr int kMostTimesRefused = 3;    // that a thing makes others go although it has places
constexpr size_t kMaxNogoods = 64;      // of a thing
constexpr double kInVain = 0.4;         // of all evictions, with no more things standing after them

}  // namespace

bool Solver::back_off(size_t item) {
  // A pattern is placed as a whole and takes nothing out; neither does an attempt that has used up
  // its evictions.
  if (m_items[item].pattern || m_no_more || m_num_evictions >= m_world.arrangement().max_evictions)
    return false;
  // Evictions that leave no more things standing than before are in vain.
  const double in_vain = m_num_evictions - m_evictions_then;
  if (in_vain > kInVain * m_world.arrangement().max_evictions) return false;
  // A thing that does not come to rest where there is room seldom does so elsewhere.
  if (!m_refused.empty() && ++m_times_refused[item] > kMostTimesRefused) return false;
  return evict_blockers(item) || evict_references(item);
}

// A thing whose places were given up for others goes back to one, so that the conflict is told of
// those others: they get no more room.
bool Solver::forget_nogoods(size_t item) {
  if (m_items[item].pattern || m_no_more) return false;
  std::vector<Vec2>& nogoods = m_nogoods[m_items[item].things.front()];
  if (nogoods.empty()) return false;
  m_no_more = true;
  nogoods.clear();
  return true;
}

// The thing where it meets all relations and what does not move, at the place where the least is
// in the way.
bool Solver::evict_blockers(size_t item) {
  const size_t thing = m_items[item].things.front();
  Placer placer(m_world, thing, seed_of(thing));
  // Places are searched as if nothing movable were there.
  const auto places = placer.candidates(Obstacles::Immovable, m_nogoods[thing], kEvictionPlaces);
  struct Choice {
    double weight;
    size_t place;
    std::vector<size_t> items;
  };
  std::vector<Choice> choices;
  for (size_t k = 0; k < places.size(); ++k) {
    if (stopped()) return false;
    // Each place costs its own energy and the weight of all that has to go, with what it carries.
    Choice choice{places[k].energy, k, items_with_loads(placer.blockers(places[k]))};
    const bool own_support = carries(choice.items, thing);
    // The own support and patterns never go.
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

bool Solver::put_instead(Placer& placer, const PlaceCandidate& place, size_t thing,
                         const std::vector<size_t>& items, size_t item) {
  // Everything is taken back if the PUT fails: scene and order.
  World::Trial trial(m_world);
  const std::vector<size_t> order = m_order;
  const std::vector<char> placed = m_placed;
  take_out(items);
  OperationResult result;
  ++m_out.num_puts;
  const auto why = placer.put(place, result);
  m_out.put_milliseconds += result.milliseconds;
  if (why) {
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

bool Solver::has_pattern(const std::vector<size_t>& items) const {
  return std::any_of(items.begin(), items.end(),
                     [&](size_t i) { return m_items[i].pattern != nullptr; });
}

bool Solver::carries(const std::vector<size_t>& items, size_t thing) const {
  const Relation* support = m_world.support_of(m_world.things()[thing]);
  if (!support) return false;
  const int below = item_of(m_world, m_items, support->b);
  return below >= 0 && std::count(items.begin(), items.end(), static_cast<size_t>(below));
}

// Evicts what the thing's relations refer to, and its support when there is nothing else: these
// places are no good.
bool Solver::evict_references(size_t item) {
  const size_t thing = m_items[item].things.front();
  std::vector<size_t> things;
  const auto collect = [&](bool supports) {
    for (const size_t r : m_world.things()[thing].relations) {
      const Relation& relation = m_world.arrangement().relations[r];
      const std::string& other = relation.a == name(thing) ? relation.b : relation.a;
      // Relations that lead to others come first; the support is the last resort.
      if (relation.is_support() != supports || (supports && relation.a != name(thing))) continue;
      if (!relation.is_hard()) continue;
      const int t = m_world.thing_of(other);
      if (t >= 0 && m_world.stands(other)) things.push_back(static_cast<size_t>(t));
    }
  };
  collect(false);
  if (things.empty()) collect(true);
  // Each with its cluster, which would hold it where it is.
  std::vector<size_t> all;
  for (const size_t t : things)
    for (const size_t member : cluster_of(t)) all.push_back(member);
  std::vector<size_t> items = items_with_loads(all);
  if (has_pattern(items)) items = items_with_loads(things);
  if (items.empty() || has_pattern(items)) return false;
  for (const size_t t : things) {
    // The place that another thing holds now is remembered as no good for it.
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

// The thing first, then what stands by it alone: all hard relations that place it are to things of
// the cluster, such as those of a knife to its plate, and of a spoon to the knife.
std::vector<size_t> Solver::cluster_of(size_t thing) const {
  std::vector<size_t> out{thing};
  // The cluster grows until no thing is left that belongs to it alone.
  const auto is_in = [&](const std::string& other) {
    const int t = m_world.thing_of(other);
    return t >= 0 && std::count(out.begin(), out.end(), static_cast<size_t>(t));
  };
  const auto follows = [&](size_t t) {
    bool refers = false;
    for (const size_t r : m_world.things()[t].relations) {
      const Relation& relation = m_world.arrangement().relations[r];
      if (!relation.is_hard() || relation.is_support() || relation.a != name(t)) continue;
      if (!is_in(relation.b)) return false;
      refers = true;
    }
    return refers;
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (const size_t t : m_order) {
      if (is_in(name(t)) || !follows(t)) continue;
      out.push_back(t);
      grows = true;
    }
  }
  return out;
}

// Items of these things and of all that they carry, each once.
std::vector<size_t> Solver::items_with_loads(const std::vector<size_t>& things) const {
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
void Solver::take_out(const std::vector<size_t>& items) {
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

void Solver::note_evictions(const std::vector<size_t>& items) {
  // A thing that was evicted is harder to evict again, so that two do not push each other out for
  // ever.
  for (const size_t i : items) m_items[i].weight *= kEvictedAgain;
  m_num_evictions += static_cast<int>(items.size());
  m_out.num_evictions += static_cast<int>(items.size());
}

}  // namespace trivet
