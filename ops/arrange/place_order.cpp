#include "ops/arrange/place_order.h"

#include <algorithm>

#include "ops/arrange/noise.h"

namespace trivet {
namespace {

constexpr double kNogoodRadius = 6e-3;  // metres
constexpr size_t kMaxSights = 2048;     // candidates whose lines of sight are looked at
constexpr size_t kSoftSights = 256;     // best candidates that soft relations of sight are added to

double square(double x) { return x * x; }

std::uint64_t counter(std::uint64_t seed, size_t combination, size_t place) {
  return scrambled(scrambled(seed ^ scrambled(combination)) ^ place);
}

bool is_of_turn(const Relation& r) {
  return r.kind == RelationKind::Aligned || r.kind == RelationKind::Parallel ||
         r.kind == RelationKind::Perpendicular || r.kind == RelationKind::Same;
}

}  // namespace

PlaceCosts::PlaceCosts(const Placer& placer, const Combination& combination)
    : m_placer(placer), m_base(combination.outline), m_here(combination.outline) {
  m_fixed.resize(placer.m_relations.size());
  for (size_t k = 0; k < m_fixed.size(); ++k)
    if (is_of_turn(*placer.m_relations[k]))
      m_fixed[k] = placer.cost(*placer.m_relations[k], m_base);
}

void PlaceCosts::move_to(const Vec2& at) {
  for (size_t i = 0; i < m_base.hull.size(); ++i) m_here.hull[i] = m_base.hull[i] + at;
  m_here.centre = m_base.centre + at;
  m_here.mass_centre = m_base.mass_centre + at;
}

double PlaceCosts::cost(size_t relation) const {
  return m_fixed[relation] ? *m_fixed[relation]
                           : m_placer.cost(*m_placer.m_relations[relation], m_here);
}

bool PlaceCosts::meets_hard() const {
  for (size_t k = 0; k < m_fixed.size(); ++k) {
    const Relation& r = *m_placer.m_relations[k];
    if (!r.is_hard()) continue;
    const bool turns_later = r.kind == RelationKind::Facing || r.kind == RelationKind::Away;
    const double slack = turns_later && r.a == m_placer.name() ? kFacingSlackDeg / r.tolerance : 0;
    if (!(cost(k) <= 1 + slack)) return false;
  }
  return true;
}

double PlaceCosts::energy() const {
  double out = 0;
  for (size_t k = 0; k < m_fixed.size(); ++k) {
    const Relation& r = *m_placer.m_relations[k];
    if (!r.is_hard()) out += *r.weight * square(cost(k));
  }
  return out;
}

// Over the landing, with all hard relations, away from nogoods.
std::vector<size_t> PlaceOrder::met(const PlaceField& field, PlaceCosts& costs) const {
  std::vector<size_t> out;
  for (size_t place = 0; place < field.size(); ++place) {
    const Vec2& at = field.at(place);
    const auto near = [&](const Vec2& p) { return (p - at).norm() < kNogoodRadius; };
    if (!field.is_over_rectangle(place) || std::any_of(m_nogoods.begin(), m_nogoods.end(), near))
      continue;
    costs.move_to(at);
    if (costs.meets_hard()) out.push_back(place);
  }
  return out;
}

void PlaceOrder::add(size_t c) {
  m_placer.m_world.check_interrupt();
  const Combination& combination = m_placer.m_combinations[c];
  auto open = std::make_unique<Open>(m_placer, combination);
  PlaceField& field = open->field;
  PlaceCosts costs(m_placer, combination);
  const std::vector<size_t> met = this->met(field, costs);
  if (met.empty()) return;
  field.leave(met);
  m_all.reserve(m_all.size() + met.size());
  for (size_t k = 0; k < met.size(); ++k) {
    costs.move_to(field.at(k));
    PlaceCandidate candidate{0, costs.energy(), c, 0, field.at(k), field.pixel()};
    candidate.key = candidate.energy -
                    m_placer.m_temperature * gumbel_noise(counter(m_placer.m_seed, c, met[k]));
    candidate.field = m_open.size();
    candidate.place = k;
    m_all.push_back(candidate);
  }
  m_open.push_back(std::move(open));
}

// Of what may be in the way in this rotation.
Obstructions PlaceOrder::obstructions(const Open& open) const {
  const World& world = m_placer.m_world;
  std::map<double, std::vector<ObjectId>> by_keep;
  for (const ObjectId id : m_placer.obstacles(open.combination, m_which))
    by_keep[world.keep(m_placer.name(), world.scene().at(id).name)].push_back(id);
  Obstructions out;
  for (const auto& [keep, ids] : by_keep) out.push_back(open.field.obstruction(ids, keep));
  const auto& supports = open.combination.landing.supports;
  const bool on_floor = std::count(supports.begin(), supports.end(), Support::floor()) > 0;
  if (world.scene().floor && !on_floor) out.push_back(open.field.obstruction_of_floor());
  for (const ObjectId id : m_placer.has_zones() ? world.standing() : std::vector<ObjectId>()) {
    const bool may_move = world.thing_of(world.scene().at(id).name) >= 0;
    if (m_which == Obstacles::All || !may_move)
      for (auto& zone : m_placer.zone_obstructions(open.field, open.combination, id))
        out.push_back(std::move(zone));
  }
  return out;
}

bool PlaceOrder::fits(PlaceCandidate& candidate) {
  Open& open = *m_open[candidate.field];
  if (!open.field.is_over_support(candidate.place)) return false;
  if (!open.in_the_way) open.in_the_way = obstructions(open);
  for (const auto& obstruction : *open.in_the_way)
    if (!obstruction->is_clear(candidate.place)) return false;
  candidate.start_z = open.field.met_at(candidate.place);
  return true;
}

bool PlaceOrder::meets_sights(const PlaceCandidate& candidate) {
  const SightTrial trial = m_placer.sight_trial(candidate, m_which);
  if (m_judges.empty())
    for (const Relation* r : m_placer.m_sights)
      m_judges.push_back(std::make_unique<SightJudge>(trial, *r));
  return std::all_of(m_judges.begin(), m_judges.end(),
                     [&](const auto& judge) { return judge->holds_at(trial.pose); });
}

// The smallest key, then the first that was added, on top.
void PlaceOrder::start() {
  m_heap.resize(m_all.size());
  for (size_t i = 0; i < m_heap.size(); ++i) m_heap[i] = i;
  const auto later = [&](size_t i, size_t j) {
    return m_all[i].key != m_all[j].key ? m_all[i].key > m_all[j].key : i > j;
  };
  std::make_heap(m_heap.begin(), m_heap.end(), later);
}

std::optional<PlaceCandidate> PlaceOrder::next() {
  if (m_heap.empty()) return std::nullopt;
  m_placer.m_world.check_interrupt();
  const auto later = [&](size_t i, size_t j) {
    return m_all[i].key != m_all[j].key ? m_all[i].key > m_all[j].key : i > j;
  };
  std::pop_heap(m_heap.begin(), m_heap.end(), later);
  const size_t i = m_heap.back();
  m_heap.pop_back();
  return m_all[i];
}

std::optional<PlaceCandidate> PlaceOrder::next_that_fits() {
  while (auto candidate = next())
    if (fits(*candidate)) return candidate;
  return std::nullopt;
}

// The best by all else, in a new order. Candidates that are not looked at stay behind: they may
// cost more than they seem to.
std::vector<PlaceCandidate> PlaceOrder::with_sight_energy() {
  std::vector<PlaceCandidate> out;
  while (out.size() < kSoftSights) {
    auto candidate = next_that_fits();
    if (!candidate) break;
    const SightTrial trial = m_placer.sight_trial(*candidate, Obstacles::All);
    double more = 0;
    for (const Relation* r : m_placer.m_relations)
      if (r->is_of_sight() && !r->is_hard()) more += *r->weight * square(sight_cost(trial, *r));
    candidate->energy += more, candidate->key += more;
    out.push_back(*candidate);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const PlaceCandidate& a, const PlaceCandidate& b) { return a.key < b.key; });
  return out;
}

std::vector<PlaceCandidate> PlaceOrder::best(size_t most) {
  start();
  std::vector<PlaceCandidate> out;
  size_t num_sights = 0;
  const auto is_close = [&](const PlaceCandidate& candidate) {
    return std::any_of(out.begin(), out.end(), [&](const PlaceCandidate& o) {
      return o.combination == candidate.combination &&
             (o.at - candidate.at).norm() < 2 * candidate.pixel;
    });
  };
  const auto take = [&](const PlaceCandidate& candidate) {
    if (m_placer.m_sights.empty() || (++num_sights <= kMaxSights && meets_sights(candidate)))
      out.push_back(candidate);
  };
  if (m_placer.m_has_soft_sights)
    for (const PlaceCandidate& candidate : with_sight_energy())
      if (out.size() < most && !is_close(candidate)) take(candidate);
  while (out.size() < most) {
    auto candidate = next();
    if (!candidate) break;
    if (!is_close(*candidate) && fits(*candidate)) take(*candidate);
  }
  return out;
}

}  // namespace trivet
