#include "ops/arrange/placer.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/noise.h"
#include "ops/arrange/zones.h"
#include "ops/detect/detector.h"
#include "ops/operations/moving_group.h"

namespace trivet {
namespace {

constexpr double kTemperature = 0.2;
constexpr double kNogoodRadius = 6e-3;  // metres
constexpr size_t kMaxPlaceCandidates = 64;
constexpr size_t kFewTurns = 3;  // of free ones, before all are tried
constexpr size_t kAllTurns = 1000;
constexpr size_t kEnoughPlaces = 12;  // candidates that a few turns are to leave
constexpr size_t kMaxSights = 2048;   // candidates whose lines of sight are looked at

std::uint64_t counter(std::uint64_t seed, size_t combination, size_t place) {
  return scrambled(scrambled(seed ^ scrambled(combination)) ^ place);
}

}  // namespace

Placer::Placer(World& world, size_t thing, std::uint64_t seed, Noise noise)
    : m_world(world),
      m_thing(thing),
      m_seed(seed),
      m_temperature(noise == Noise::On ? kTemperature : 0),
      m_clearance(world.clearance(model())) {
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

// @param slack_deg  of things that are turned to face something afterwards.
bool Placer::meets_hard(const Outline& outline, double slack_deg) const {
  for (const Relation* r : m_relations) {
    if (!r->is_hard()) continue;
    const bool turns_later = r->kind == RelationKind::Facing || r->kind == RelationKind::Away;
    const double slack = turns_later && r->a == name() ? slack_deg / r->tolerance : 0;
    if (!(cost(*r, outline) <= 1 + slack)) return false;
  }
  return true;
}

double Placer::energy(const Outline& outline) const {
  double out = 0;
  for (const Relation* r : m_relations) {
    if (r->is_hard()) continue;
    const double c = cost(*r, outline);
    out += *r->weight * c * c;
  }
  return out;
}

// Others that are not kept apart by a relation.
std::vector<ObjectId> Placer::obstacles(const Combination& combination, Obstacles which) const {
  std::vector<ObjectId> out;
  for (const ObjectId id : m_world.standing()) {
    const std::string& other = m_world.scene().at(id).name;
    const auto& supports = combination.landing.supports;
    if (id == model().id || std::count(supports.begin(), supports.end(), Support(id))) continue;
    if (which == Obstacles::Immovable && m_world.thing_of(other) >= 0) continue;
    const double keep = m_world.keep(name(), other);
    const auto apart = [&](const Relation* r) {
      return separates(*r) && (r->a == other || r->b == other) && keep <= r->lower;
    };
    if (std::none_of(m_relations.begin(), m_relations.end(), apart)) out.push_back(id);
  }
  return out;
}

std::vector<char> Placer::clear(const PlaceField& field, const Combination& combination,
                                Obstacles which) const {
  std::map<double, std::vector<ObjectId>> by_keep;
  for (const ObjectId id : obstacles(combination, which))
    by_keep[m_world.keep(name(), m_world.scene().at(id).name)].push_back(id);
  std::vector<char> out(field.size(), 1);
  const auto take = [&](const std::vector<char>& other) {
    for (size_t i = 0; i < out.size(); ++i) out[i] &= other[i];
  };
  for (const auto& [keep, ids] : by_keep) take(field.clear_of(ids, keep));
  const auto& supports = combination.landing.supports;
  const bool on_floor = std::count(supports.begin(), supports.end(), Support::floor()) > 0;
  if (m_world.scene().floor && !on_floor) take(field.clear_of_floor());
  for (const ObjectId id : has_zones() ? m_world.standing() : std::vector<ObjectId>()) {
    const bool may_move = m_world.thing_of(m_world.scene().at(id).name) >= 0;
    if (which == Obstacles::All || !may_move) take(zones_clear_of(field, combination, id));
  }
  return out;
}

std::vector<char> Placer::zones_clear_of(const PlaceField& field, const Combination& combination,
                                         ObjectId other) const {
  std::vector<char> out(field.size(), 1);
  if (other == model().id) return out;
  const Object& object = m_world.scene().at(other);
  const auto take = [&](const std::vector<char>& clear) {
    for (size_t i = 0; i < out.size(); ++i) out[i] &= clear[i];
  };
  for (const Body& zone : zones_of(m_world, object.name, object.pose))
    take(field.clear_of_bodies({&zone, 1}));
  const auto& supports = combination.landing.supports;
  if (std::count(supports.begin(), supports.end(), Support(other))) return out;
  const Body body = body_of(object);
  for (const Body& zone : zones_of(m_world, name(), {combination.rotation, Vec3::Zero()}))
    take(field.clear_of_bodies({&zone, 1}, {&body, 1}));
  return out;
}

// Over the support, with all hard relations, away from nogoods.
bool Placer::is_met(const PlaceField& field, size_t place, const Combination& combination,
                    const std::vector<Vec2>& nogoods) const {
  if (!field.is_over_support(place)) return false;
  const Vec2& at = field.at(place);
  const auto near = [&](const Vec2& p) { return (p - at).norm() < kNogoodRadius; };
  return std::none_of(nogoods.begin(), nogoods.end(), near) &&
         meets_hard(moved(combination.outline, at), kFacingSlackDeg);
}

void Placer::add_candidates(size_t c, Obstacles which, const std::vector<Vec2>& nogoods,
                            std::vector<PlaceCandidate>& all) const {
  m_world.check_interrupt();
  const Combination& combination = m_combinations[c];
  const PlaceField field = this->field(combination);
  // The first place that relations leave; what is clear is not asked for if there is none.
  size_t i = 0;
  while (i < field.size() && !is_met(field, i, combination, nogoods)) ++i;
  if (i == field.size()) return;
  const std::vector<char> clear = this->clear(field, combination, which);
  for (; i < field.size(); ++i) {
    if (!clear[i] || !is_met(field, i, combination, nogoods)) continue;
    const Vec2& at = field.at(i);
    PlaceCandidate candidate{
        0, energy(moved(combination.outline, at)), c, field.met_at(i), at, field.pixel()};
    candidate.key = candidate.energy - m_temperature * gumbel_noise(counter(m_seed, c, i));
    all.push_back(candidate);
  }
}

// A few of the turns, where any will do, by the seed; all, if they leave too few places.
std::vector<PlaceCandidate> Placer::candidates(Obstacles which,
                                               const std::vector<Vec2>& nogoods) const {
  if (!m_turns_are_free) return best_of(all_candidates(which, nogoods, 0, kAllTurns), which);
  auto some = all_candidates(which, nogoods, 0, kFewTurns);
  std::vector<PlaceCandidate> out = best_of(some, which);
  if (out.size() >= kEnoughPlaces) return out;
  const auto others = all_candidates(which, nogoods, kFewTurns, kAllTurns);
  some.insert(some.end(), others.begin(), others.end());
  return best_of(std::move(some), which);
}

// Of the turns whose ranks by the seed are in [first, last).
std::vector<PlaceCandidate> Placer::all_candidates(Obstacles which,
                                                   const std::vector<Vec2>& nogoods, size_t first,
                                                   size_t last) const {
  std::vector<PlaceCandidate> out;
  const auto key = [&](size_t turn) { return scrambled(m_seed ^ scrambled(~turn)); };
  for (size_t c = 0; c < m_combinations.size(); ++c) {
    size_t rank = 0;
    for (size_t turn = 0; m_turns_are_free && turn < m_num_turns; ++turn)
      rank += key(turn) < key(m_combinations[c].turn) ? 1 : 0;
    if (rank >= first && rank < last) add_candidates(c, which, nogoods, out);
  }
  return out;
}

// The best first, a pixel or more from each other, as lines of sight leave them.
std::vector<PlaceCandidate> Placer::best_of(std::vector<PlaceCandidate> all,
                                            Obstacles which) const {
  const auto by_key = [](const PlaceCandidate& a, const PlaceCandidate& b) {
    return a.key < b.key;
  };
  std::stable_sort(all.begin(), all.end(), by_key);
  // Candidates that were not looked at stay behind: they may cost more than they seem to.
  if (m_has_soft_sights)
    std::stable_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(add_sight_energy(all)),
                     by_key);
  size_t num_sights = 0;
  std::vector<PlaceCandidate> out;
  for (const PlaceCandidate& candidate : all) {
    m_world.check_interrupt();
    const auto close = [&](const PlaceCandidate& o) {
      return o.combination == candidate.combination &&
             (o.at - candidate.at).norm() < 2 * candidate.pixel;
    };
    if (std::any_of(out.begin(), out.end(), close)) continue;
    if (!m_sights.empty() && (++num_sights > kMaxSights || !meets_sights(candidate, which)))
      continue;
    out.push_back(candidate);
    if (out.size() == kMaxPlaceCandidates) break;
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
  for (const ObjectId id : obstacles(combination, Obstacles::All)) {
    const std::string& other = m_world.scene().at(id).name;
    if (m_world.thing_of(other) >= 0)
      note(id, field.clear_of({&id, 1}, m_world.keep(name(), other)));
  }
  for (const ObjectId id : has_zones() ? m_world.standing() : std::vector<ObjectId>())
    note(id, zones_clear_of(field, here, id));
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
