// One attempt at an arrangement: things in their order, PUTs, and what gives way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/arrange.h"
#include "ops/arrange/items.h"
#include "ops/base/interrupt.h"

namespace trivet {

/// PUTs of a thing before others have to give way.
inline constexpr size_t kTrials = 12;

class Solver {
 public:
  /// @param out  counts, and why there is no arrangement; all of these outlive the solver.
  Solver(World& world, std::uint64_t seed, Interrupt& interrupt, const ArrangeProgress& progress,
         ArrangeResult& out);

  /// False: out.conflict says why, or out.status that it was stopped.
  bool run();
  /// After run(): lowers the cost of soft relations by moving things with what they carry, alone or
  /// as clusters; the scene is as true after each, and never worse. Bounded; ends early when it is
  /// interrupted.
  void improve();
  /// Results and costs of relations, after run().
  void finish();
  /// True of a thing that had a place at some time, though it may have lost it.
  bool has_stood(const std::string& name) const;

 private:
  const std::string& name(size_t thing) const { return m_world.things()[thing].thing->object; }
  std::string name_of(size_t item) const { return name(m_items[item].things.front()); }
  size_t standing() const { return m_order.size(); }
  bool place_all();
  bool stopped();
  std::uint64_t seed_of(size_t thing) const;
  void note_placed(size_t thing, OperationResult result);
  enum class LookAhead { On, Off };
  bool put(Placer& placer, const PlaceCandidate& candidate, size_t thing, LookAhead looks);
  bool place_thing(size_t item);
  bool place_pattern(size_t item);
  void explain(size_t item);
  std::optional<Sentence> leaves_no_room(size_t thing);

  // improve.cpp
  double soft_cost(const Relation& relation) const;
  double soft_cost(std::vector<double>& of_thing) const;
  bool move_for_less(size_t thing, const std::vector<size_t>& with, double own, double& cost);
  bool put_at_least(size_t thing, double most);

  // No place is left: eviction.cpp.
  bool back_off(size_t item);
  bool forget_nogoods(size_t item);
  bool evict_blockers(size_t item);
  bool put_instead(Placer& placer, const PlaceCandidate& place, size_t thing,
                   const std::vector<size_t>& items, size_t item);
  bool evict_references(size_t item);
  bool has_pattern(const std::vector<size_t>& items) const;
  bool carries(const std::vector<size_t>& items, size_t thing) const;
  std::vector<size_t> cluster_of(size_t thing) const;
  std::vector<size_t> items_with_loads(const std::vector<size_t>& things) const;
  void take_out(const std::vector<size_t>& items);
  void note_evictions(const std::vector<size_t>& items);

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
  std::vector<char> m_had_no_place;          // #things: at some time, for others
  std::vector<char> m_has_stood;             // #things: at some time
  std::vector<int> m_in_vain;                // #things: looks ahead since it stood last
  size_t m_most_standing = 0;                // things, at any time
  int m_evictions_then = 0;                  // when so many stood first
  bool m_left_no_room = false;               // the last PUT was kept but for what follows
  Sentence m_refused;                        // of the first PUT of this item
  std::vector<int> m_times_refused;          // #items: places, but no PUT was kept
  int m_num_evictions = 0;
  bool m_no_more = false;  // nothing is evicted any more
};

}  // namespace trivet
