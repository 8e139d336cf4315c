#include "ops/arrange/placer.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/noise.h"
#include "ops/arrange/place_order.h"
#include "ops/arrange/zones.h"
#include "ops/detect/detector.h"

namespace trivet {
namespace {

constexpr double kTemperature = 0.2;

}  // namespace

Placer::Placer(World& world, size_t thing, std::uint64_t seed, Noise noise)
    : m_world(world),
      m_thing(thing),
      m_seed(seed),
      m_temperature(noise == Noise::On ? kTemperature : 0),
      m_clearance(world.clearance(model())) {
  // Only relations to what stands already, or to nothing, can be judged now; others wait for their
  // object.
  for (const size_t r : model().relations) {
    const Relation& relation = m_world.arrangement().relations[r];
    if (relation.is_support()) continue;
    const std::string& other = relation.a == name() ? relation.b : relation.a;
    if (!other.empty()) {
      if (!m_world.stands(other)) continue;
      if (!m_partners.count(other)) m_partners.emplace(other, m_world.outline(other));
    }
    m_relations.push_back(&relation);
  }
  m_sights = sights_of({m_world, static_cast<int>(thing), {}});
  m_has_soft_sights = std::any_of(m_relations.begin(), m_relations.end(), [](const Relation* r) {
    return r->is_of_sight() && !r->is_hard();
  });
  combine();
}

const Outline* Placer::partner(const Relation& relation) const {
  const auto it = m_partners.find(relation.a == name() ? relation.b : relation.a);
  return it == m_partners.end() ? nullptr : &it->second;
}

double Placer::cost(const Relation& relation, const Outline& outline) const {
  if (relation.a == name()) return relation_cost(relation, outline, partner(relation));
  return relation_cost(relation, *partner(relation), &outline);
}

PlaceField Placer::field(const Combination& c) const {
  return {m_world.scene(),
          model().id,
          c.rotation,
          c.landing,
          c.region,
          m_clearance,
          drop_brackets_of(m_world.setting().context.detector)};
}

// Others that are not kept apart by a relation.
std::vector<ObjectId> Placer::obstacles(const Combination& combination, Obstacles which) const {
  std::vector<ObjectId> out;
  for (const ObjectId id : m_world.standing()) {
    const std::string& other = m_world.scene().at(id).name;
    const auto& supports = combination.landing.supports;
    // The support is no obstacle, nor is what a relation keeps farther away anyway.
    if (id == model().id || std::count(supports.begin(), supports.end(), Support(id))) continue;
    if (which == Obstacles::Immovable && m_world.thing_of(other) >= 0) continue;
    const double keep = m_world.keep(name(), other);
    const auto apart = [&](const Relation* r) {
      return separates(*r) && (r->a == other || r->b == other) && keep <= gap_of(*r).lower;
    };
    if (std::none_of(m_relations.begin(), m_relations.end(), apart)) out.push_back(id);
  }
  return out;
}

Obstructions Placer::zone_obstructions(const PlaceField& field, const Combination& combination,
                                       ObjectId other) const {
  Obstructions out;
  if (other == model().id) return out;
  const Object& object = m_world.scene().at(other);
  // Zones of others are obstacles to the thing; others are obstacles to its own zones.
  for (const Body& zone : zones_of(m_world, object.name, object.pose))
    out.push_back(field.obstruction({&zone, 1}));
  const auto& supports = combination.landing.supports;
  if (std::count(supports.begin(), supports.end(), Support(other))) return out;
  const Body body = body_of(object);
  for (const Body& zone : zones_of(m_world, name(), {combination.rotation, Vec3::Zero()}))
    out.push_back(field.obstruction({&zone, 1}, {&body, 1}));
  return out;
}

std::vector<char> Placer::zones_clear_of(const PlaceField& field, const Combination& combination,
                                         ObjectId other) const {
  std::vector<char> out(field.size(), 1);
  for (const auto& zone : zone_obstructions(field, combination, other))
    for (size_t place = 0; place < out.size(); ++place)
      out[place] &= static_cast<char>(zone->is_clear(place));
  return out;
}

// Rank among the free turns, by the seed.
size_t Placer::rank_of_turn(size_t turn) const {
  // Counters by the seed give a random order without state.
  const auto key = [&](size_t t) { return scrambled(m_seed ^ scrambled(~t)); };
  size_t out = 0;
  for (size_t t = 0; t < m_num_turns; ++t) out += key(t) < key(turn) ? 1 : 0;
  return out;
}

std::vector<PlaceCandidate> Placer::candidates(Obstacles which, const std::vector<Vec2>& nogoods,
                                               size_t most) const {
  PlaceOrder places(*this, which, nogoods);
  std::vector<PlaceCandidate> out;
  while (out.size() < most) {
    const auto next = places.next();
    if (!next) break;
    out.push_back(*next);
  }
  return out;
}

std::vector<size_t> Placer::blockers(const PlaceCandidate& candidate) const {
  const Combination& combination = m_combinations[candidate.combination];
  // At this one place alone.
  Combination here = combination;
  const Vec2 little = Vec2::Constant(1e-3 * candidate.pixel);
  here.region = ConvexRegion(candidate.at - little, candidate.at + little);
  const PlaceField field = this->field(here);
  std::vector<size_t> out;
  const auto note = [&](ObjectId id, const std::vector<char>& clear) {
    const int t = m_world.thing_of(m_world.scene().at(id).name);
    if (t >= 0 && std::count(clear.begin(), clear.end(), 0)) out.push_back(static_cast<size_t>(t));
  };
  // A movable thing is in the way if the place would be clear without it.
  for (const ObjectId id : obstacles(combination, Obstacles::All)) {
    const std::string& other = m_world.scene().at(id).name;
    if (m_world.thing_of(other) >= 0)
      note(id, field.clear_of({&id, 1}, m_world.keep(name(), other)));
  }
  for (const ObjectId id : has_zones() ? m_world.standing() : std::vector<ObjectId>())
    note(id, zones_clear_of(field, here, id));
  // A broken line of sight has its blockers between eye and object.
  for (const Relation* r : m_sights) {
    const SightTrial trial = sight_trial(candidate, Obstacles::All);
    if (sight_cost(trial, *r) <= 1) continue;
    const std::vector<size_t> between = things_between(trial, *r);
    out.insert(out.end(), between.begin(), between.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace trivet
