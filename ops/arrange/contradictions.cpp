#include "ops/arrange/contradictions.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/distance_bounds.h"

namespace trivet {
namespace {

Sentence metres(double value) { return figure(value, 4); }

}  // namespace

class ContradictionSearch {
 public:
  explicit ContradictionSearch(const World& world) : m_world(world), m_bounds(world) {
    // Only relations that keep their objects apart can be contradicted by a chain that keeps them
    // together.
    for (const Relation& r : world.arrangement().relations)
      if (r.is_hard() && has_least_distance(r) && gap_of(r).lower > r.tolerance)
        m_least_of[m_bounds.node_of(r.a)].push_back(&r);
  }

  std::optional<Conflict> run() {
    auto conflict = missing_level();
    return conflict ? conflict : too_near();
  }

 private:
  using Bounds = DistanceBounds::Bounds;

  std::optional<Conflict> missing_level() const;
  std::optional<Conflict> missing_level(const std::string& thing, const std::string& on,
                                        int level) const;
  std::optional<Conflict> too_near() const;
  std::optional<Conflict> judge(size_t a, const Bounds& bounds) const;
  Conflict conflict_of(size_t a, size_t b, const Bounds& bounds, const Sentence& asked,
                       double wanted, double most, const Relation* relation) const;
  const std::string& name(size_t node) const { return m_bounds.nodes()[node].name; }
  size_t index_of(const Relation& r) const {
    return static_cast<size_t>(&r - m_world.arrangement().relations.data());
  }

  const World& m_world;
  DistanceBounds m_bounds;
  std::map<size_t, std::vector<const Relation*>> m_least_of;  // with a least distance, by a's node
};

std::optional<Conflict> ContradictionSearch::too_near() const {
  double keep = 0;
  for (const KeepApart& k : m_world.arrangement().keeps) keep = std::max(keep, k.distance);
  for (size_t i = 0; i < m_bounds.nodes().size(); ++i) {
    m_world.check_interrupt();
    // The search from here goes as far as anything asks for, and no farther.
    const auto least = m_least_of.find(i);
    double most = m_world.thing_of(name(i)) >= 0 ? keep : 0;
    if (least != m_least_of.end())
      for (const Relation* r : least->second) most = std::max(most, gap_of(*r).lower);
    if (!(most > 0)) continue;
    if (auto conflict = judge(i, m_bounds.from(i, most))) return conflict;
  }
  return std::nullopt;
}

std::optional<Conflict> ContradictionSearch::judge(size_t a, const Bounds& bounds) const {
  // A relation that asks for more than the chain allows is a contradiction; so is a distance to
  // keep.
  if (const auto least = m_least_of.find(a); least != m_least_of.end())
    for (const Relation* r : least->second) {
      const size_t b = m_bounds.node_of(r->b);
      const auto bound = bounds.find(b);
      const double lower = gap_of(*r).lower;
      if (bound != bounds.end() && bound->second.distance < lower - r->tolerance)
        return conflict_of(a, b, bounds, r->text(), lower, bound->second.distance, r);
    }
  const DistanceBounds::Node& node = m_bounds.nodes()[a];
  for (const auto& [b, bound] : bounds) {
    const DistanceBounds::Node& other = m_bounds.nodes()[b];
    // Two that stand already cannot be moved, and their distance is not of the arrangement's
    // making.
    const bool may_move = m_world.thing_of(node.name) >= 0 || m_world.thing_of(other.name) >= 0;
    if (b == a || !may_move || m_bounds.touch(node.name, other.name)) continue;
    const double most = m_bounds.apart(node, other, bound.distance);
    const double keep = m_world.keep(node.name, other.name);
    if (most < keep)
      return conflict_of(
          a, b, bounds, say("%1 %2 m from %3", quoted(node.name), metres(keep), quoted(other.name)),
          keep, most, nullptr);
  }
  return std::nullopt;
}

Conflict ContradictionSearch::conflict_of(size_t a, size_t b, const Bounds& bounds,
                                          const Sentence& asked, double wanted, double most,
                                          const Relation* relation) const {
  Conflict out;
  // The way back through the bounds is the chain of relations.
  std::vector<size_t> chain{b};
  std::vector<const DistanceBounds::Link*> links;
  for (size_t at = b; at != a; at = bounds.at(at).from) {
    links.push_back(bounds.at(at).by);
    chain.push_back(bounds.at(at).from);
  }
  std::reverse(links.begin(), links.end());
  // The first of the chain, from a on, that may move is the one that has no place.
  const auto thing = std::find_if(chain.rbegin(), chain.rend(),
                                  [&](size_t n) { return m_world.thing_of(name(n)) >= 0; });
  out.thing = name(thing == chain.rend() ? a : *thing);
  out.constraints = {asked};
  if (relation) out.relations = {index_of(*relation)};
  for (const DistanceBounds::Link* link : links) {
    if (!link->text.empty()) out.constraints.push_back(link->text);
    if (link->relation) out.relations.push_back(index_of(*link->relation));
  }
  for (auto it = chain.rbegin(); it != chain.rend(); ++it)
    if (name(*it) != out.thing) out.objects.push_back(name(*it));
  out.missing = wanted - most;
  out.is_certain = true;
  if (!out.relations.empty()) out.cheapest = out.relations.front();
  out.text =
      say("%1 has no place: these leave none together: %2; %3 and %4 are %5 m apart at most, "
          "%6 m are asked for",
          trivet::quoted(out.thing), listed(out.constraints), quoted(name(a)), quoted(name(b)),
          metres(most), metres(wanted));
  return out;
}

// Looks at supports that stand, and at those that have one pose alone.
std::optional<Conflict> ContradictionSearch::missing_level() const {
  for (const Relation& r : m_world.arrangement().relations) {
    const auto* const on = r.as<relations::On>();
    if (!on || !on->level || r.b == kFloorName) continue;
    if (auto out = missing_level(r.a, r.b, *on->level)) {
      out->relations = {index_of(r)};
      return out;
    }
  }
  for (const Pattern& p : m_world.arrangement().patterns)
    if (p.level && p.on != kFloorName)
      if (auto out = missing_level(p.things.front(), p.on, *p.level)) return out;
  return std::nullopt;
}

std::optional<Conflict> ContradictionSearch::missing_level(const std::string& thing,
                                                           const std::string& on, int level) const {
  const auto count = m_world.num_levels(on);
  if (!count || is_level(*count, level)) return std::nullopt;
  Conflict out;
  out.thing = thing;
  out.constraints = {say("on %1, level %2", quoted(on), level)};
  out.objects = {on};
  out.is_certain = true;
  out.text = say("%1 has no place %2: %3", quoted(thing), out.constraints.front(),
                 no_such_level(on, *count, level));
  return out;
}

std::optional<Conflict> find_contradiction(const World& world) {
  return ContradictionSearch(world).run();
}

}  // namespace trivet
