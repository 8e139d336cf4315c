// Private. The search for a conflict of one thing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/conflict.h"

namespace trivet {

class ConflictSearch {
 public:
  ConflictSearch(World& world, size_t thing)
      : m_world(world), m_placer(world, thing, 0), m_thing(world.things()[thing]) {
    m_out.thing = m_thing.thing->object;
  }

  Conflict run(const Sentence& refused);

 private:
  using Set = std::vector<size_t>;              // of relations, or of constraints
  using Slack = std::function<double(size_t)>;  // metres that a relation's planes give way by
  using Mask = std::vector<std::uint64_t>;      // places that a constraint leaves
  // Over all places of all poses.
  struct Constraint {
    Sentence text;
    std::string object;  // that it names; may be empty
    const Relation* relation = nullptr;
    Mask mask = {};
    std::vector<size_t> unseen = {};  // of sight: places for which others speak, from coarse to
                                      // fine
  };
  struct Judged {
    size_t pose;
    Vec2 at;
    double start_z;  // of the position, where it meets the support
  };

  Sentence where() const;
  std::string support() const;
  void make_poses();
  const std::string& other_of(const Relation& r) const { return r.a == m_out.thing ? r.b : r.a; }
  size_t index_of(const Relation& r) const {
    return static_cast<size_t>(&r - m_world.arrangement().relations.data());
  }
  void note(const std::string& object);
  void add(const Relation& r);
  void write();

  // By outlines.
  ConvexRegion region(const Combination& c, const Set& set, const Slack& slack) const;
  bool leaves_nothing(const Set& set, const Slack& slack) const;
  double least_slack(const Set& set, const std::function<bool(size_t)>& gives) const;
  bool find_in_outlines();
  bool find_set();
  Sentence between(const Set& set) const;
  bool is_certain() const;

  // By masks: conflict_masks.cpp.
  void fill_masks();
  void fill_sights();
  bool all_but_sights_hold(size_t place) const;
  Sentence zones_text(const std::string& other) const;
  bool nearly_holds(const Relation& r, const Outline& outline, double pixel) const;
  bool find_in_masks();
  std::vector<char> sight_holds(const Relation& r, std::span<const size_t> places) const;
  bool is_refuted(const Set& set, Constraint& sight);
  bool leaves_no_place(const Set& set) const;
  bool surely_leaves_no_place(const Set& set);
  void find_cheapest(const Set& set);

  World& m_world;
  Placer m_placer;
  const ThingModel& m_thing;
  std::vector<Combination> m_poses;          // a rotation and a way down each, without any relation
  std::vector<const Relation*> m_relations;  // hard, judged by outlines
  std::vector<Constraint> m_constraints;
  std::vector<Judged> m_places;
  Sentence m_why_none;
  Sentence m_between;       // and what they leave, of two relations to objects on opposite sides
  bool m_anywhere = false;  // relations alone, without what the support leaves
  Conflict m_out;
};

/// Smallest set of so many that leaves nothing: sizes 1 to 3, then by deletion from all.
/// nullopt: all together leave something.
std::optional<std::vector<size_t>> smallest_empty(
    size_t count, const std::function<bool(const std::vector<size_t>&)>& leaves_nothing);

}  // namespace trivet
