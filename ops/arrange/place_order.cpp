#include "ops/arrange/place_order.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ops/arrange/noise.h"

namespace trivet {
namespace {

constexpr double kNogoodRadius = 6e-3;  // metres
constexpr size_t kFewTurns = 3;         // of free ones, before all are tried
constexpr double kLittleCosine = 1e-6;  // far more than rounding
constexpr double kLittleWay = 1e-9;     // metres, likewise
constexpr size_t kMaxSights = 2048;     // candidates whose lines of sight are looked at
constexpr size_t kSoftSights = 256;     // best candidates that soft relations of sight are added to

double square(double x) { return x * x; }

std::uint64_t counter(std::uint64_t seed, size_t combination, size_t place) {
  return scrambled(scrambled(seed ^ scrambled(combination)) ^ place);
}

// Tolerances more for a thing that is turned to face something afterwards.
double slack_of(const Relation& r, const std::string& thing) {
  return r.faces() && r.a == thing ? kFacingSlackDeg / r.tolerance : 0;
}

}  // namespace

PlaceCosts::PlaceCosts(const Placer& placer, const Combination& combination)
    : m_placer(placer), m_base(combination.outline), m_here(combination.outline) {
  m_fixed.resize(placer.m_relations.size());
  m_cosines.assign(m_fixed.size(), kInfinity);
  m_known.resize(m_fixed.size());
  // Each relation is judged in the cheapest way that is still exact: by planes, by the turn alone,
  // by a cosine, or by its cost.
  for (size_t k = 0; k < m_fixed.size(); ++k) {
    const Relation& r = *placer.m_relations[k];
    if (!r.is_hard()) m_soft.push_back(k);
    if (r.is_hard() && !(is_decided_by_planes(r) && r.tolerance > kLittleWay)) m_hard.push_back(k);
    if (r.is_of_turn()) m_fixed[k] = placer.cost(r, m_base);
    const double widest_deg = r.tolerance * (1 + slack_of(r, placer.name()));
    if (r.a == placer.name() && widest_deg < 180 && r.faces())
      m_cosines[k] = turned_about_z(widest_deg).matrix()(0, 0);
  }
}

void PlaceCosts::move_to(const Vec2& at) {
  m_at = at;
  m_has_hull = false;
  m_here.centre = m_base.centre + at;
  m_here.mass_centre = m_base.mass_centre + at;
}

const Outline& PlaceCosts::here() const {
  if (m_has_hull) return m_here;
  for (size_t i = 0; i < m_base.hull.size(); ++i) m_here.hull[i] = m_base.hull[i] + m_at;
  m_has_hull = true;
  return m_here;
}

double PlaceCosts::cost(size_t relation) const {
  return m_fixed[relation] ? *m_fixed[relation]
                           : m_placer.cost(*m_placer.m_relations[relation], here());
}

// Cheap conditions first: they leave most places out.
bool PlaceCosts::meets_hard() const {
  const auto& all = m_placer.m_relations;
  for (const size_t k : m_hard)
    if (!faces(k).value_or(true) || m_fixed[k].value_or(0) > 1) return false;
  for (const size_t k : m_hard) {
    if (faces(k)) continue;
    if (all[k]->as<relations::Near>()) {
      if (!is_near(k)) return false;
      continue;
    }
    if (!(cost(k) <= 1 + slack_of(*all[k], m_placer.name()))) return false;
  }
  return true;
}

// By cosines, where the angle is certainly within its bound, or beyond it: nullopt: it is near.
std::optional<bool> PlaceCosts::faces(size_t relation) const {
  const double least = m_cosines[relation];
  if (!(least < kInfinity)) return std::nullopt;
  const Relation& r = *m_placer.m_relations[relation];
  const double cosine = m_here.front.dot(wanted_front(r, m_here, m_placer.partner(r)));
  if (std::abs(cosine - least) < kLittleCosine) return std::nullopt;
  return cosine > least;
}

// No distance changes by more than the way from where it was measured: near its bounds it is
// measured again. One below its upper end may be too large, as Near::distance() says.
bool PlaceCosts::is_near(size_t relation) const {
  const Relation& r = *m_placer.m_relations[relation];
  const relations::Near& near = *r.as<relations::Near>();
  Known& known = m_known[relation];
  // The distance that was measured somewhere near bounds the one here.
  const double way = (m_here.mass_centre - known.at).norm() + kLittleWay;
  if (known.distance >= 0) {
    const bool is_exact = near.lower > 0 || known.distance > near.upper;
    if (is_exact && known.distance - way > near.upper + r.tolerance) return false;
    if (known.distance + way <= near.upper &&
        (near.lower == 0 || known.distance - way >= near.lower))
      return true;
  }
  const Outline& partner = *m_placer.partner(r);
  const bool is_a = r.a == m_placer.name();
  known = {m_here.mass_centre, near.distance(is_a ? here() : partner, is_a ? partner : here())};
  return near.cost_at(r, known.distance) <= 1;
}

double PlaceCosts::energy() const {
  double out = 0;
  for (const size_t k : m_soft) out += *m_placer.m_relations[k]->weight * square(cost(k));
  return out;
}

// Over the landing, with all hard relations, away from nogoods.
std::vector<size_t> PlaceOrder::met(Open& open) const {
  const PlaceField& field = open.field;
  // Relations are cheap at a place: only places that meet them are kept.
  std::vector<size_t> out;
  for (size_t place = 0; place < field.size(); ++place) {
    const Vec2& at = field.at(place);
    const auto near = [&](const Vec2& p) { return (p - at).norm() < kNogoodRadius; };
    if (!field.is_over_rectangle(place) || std::any_of(m_nogoods.begin(), m_nogoods.end(), near))
      continue;
    open.costs.move_to(at);
    if (open.costs.meets_hard()) out.push_back(place);
  }
  return out;
}

PlaceOrder::PlaceOrder(const Placer& placer, Obstacles which, const std::vector<Vec2>& nogoods)
    : m_placer(placer), m_which(which), m_nogoods(nogoods), m_has_more(placer.m_turns_are_free) {
  add_turns(true);
}

// A few of the turns, by the seed, where any will do, then the others.
void PlaceOrder::add_turns(bool few) {
  m_heap.clear();
  m_num_sights = 0;
  for (size_t c = 0; c < m_placer.m_combinations.size(); ++c) {
    // Free turns are costly together: a few, chosen by the seed, usually are enough.
    const size_t turn = m_placer.m_combinations[c].turn;
    if (!m_placer.m_turns_are_free || (m_placer.rank_of_turn(turn) < kFewTurns) == few) add(c);
  }
  std::make_heap(m_heap.begin(), m_heap.end(), is_later);
  if (m_placer.m_has_soft_sights) m_first = with_sight_energy();
}

// The places that all relations leave in one rotation, whatever is in the way.
void PlaceOrder::add(size_t c) {
  m_placer.m_world.check_interrupt();
  auto open = std::make_unique<Open>(m_placer, c);
  const std::vector<size_t> met = this->met(*open);
  if (met.empty()) return;
  open->field.leave(met);
  m_heap.reserve(m_heap.size() + met.size());
  // Noise alone is the key at first: soft costs are added when a place comes to the top.
  for (size_t k = 0; k < met.size(); ++k) {
    const double noise = gumbel_noise(counter(m_placer.m_seed, c, met[k]));
    m_heap.push_back({-m_placer.m_temperature * noise, std::nullopt,
                      static_cast<std::uint32_t>(m_open.size()), static_cast<std::uint32_t>(k)});
  }
  m_open.push_back(std::move(open));
}

// Obstructions in this rotation.
Obstructions PlaceOrder::obstructions(const Open& open) const {
  const World& world = m_placer.m_world;
  // Objects that are kept apart by the same distance share one map.
  std::map<double, std::vector<ObjectId>> by_keep;
  for (const ObjectId id : m_placer.obstacles(open.combination, m_which))
    by_keep[world.keep(m_placer.name(), world.scene().at(id).name)].push_back(id);
  Obstructions out;
  out.reserve(by_keep.size() + 1);
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
  // The support goes first: it decides most places, and needs no maps of others.
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
  // Judges keep their obstacles from place to place.
  const bool are_new = m_judges.empty();
  m_judges.reserve(m_placer.m_sights.size());
  if (are_new)
    for (const Relation* r : m_placer.m_sights)
      m_judges.push_back(std::make_unique<SightJudge>(trial, *r));
  return std::all_of(m_judges.begin(), m_judges.end(),
                     [&](const auto& judge) { return judge->holds_at(trial.pose); });
}

std::optional<PlaceCandidate> PlaceOrder::pop() {
  while (!m_heap.empty()) {
    m_placer.m_world.check_interrupt();
    std::pop_heap(m_heap.begin(), m_heap.end(), is_later);
    // The best key either has its soft costs already, and is the best of all, or gets them and goes
    // back.
    Entry& best = m_heap.back();
    if (best.energy) {
      const PlaceCandidate out = candidate_of(best);
      m_heap.pop_back();
      return out;
    }
    add_soft_costs(best);
    std::push_heap(m_heap.begin(), m_heap.end(), is_later);
  }
  return std::nullopt;
}

// Soft costs only raise a key: what comes first with them, of all that might, is the best.
void PlaceOrder::add_soft_costs(Entry& entry) {
  Open& open = *m_open[entry.field];
  open.costs.move_to(open.field.at(entry.place));
  entry.energy = open.costs.energy();
  entry.key += *entry.energy;
}

PlaceCandidate PlaceOrder::candidate_of(const Entry& entry) const {
  const Open& open = *m_open[entry.field];
  PlaceCandidate out;
  out.key = entry.key, out.energy = *entry.energy;
  out.combination = open.index;
  out.at = open.field.at(entry.place), out.pixel = open.field.pixel();
  out.field = entry.field, out.place = entry.place;
  return out;
}

// The best by all else, in a new order, the best of all at the back. Candidates that are not looked
// at stay behind: they may cost more than they seem to.
std::vector<PlaceCandidate> PlaceOrder::with_sight_energy() {
  std::vector<PlaceCandidate> out;
  // Sights are costly: only the best by all else get theirs.
  while (out.size() < kSoftSights) {
    auto candidate = pop();
    if (!candidate) break;
    if (!fits(*candidate)) continue;
    const SightTrial trial = m_placer.sight_trial(*candidate, Obstacles::All);
    double more = 0;
    for (const Relation* r : m_placer.m_relations)
      if (r->is_of_sight() && !r->is_hard()) more += *r->weight * square(sight_cost(trial, *r));
    candidate->energy += more, candidate->key += more;
    out.push_back(*candidate);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const PlaceCandidate& a, const PlaceCandidate& b) { return a.key < b.key; });
  std::reverse(out.begin(), out.end());
  return out;
}

bool PlaceOrder::is_close(const PlaceCandidate& candidate) const {
  return std::any_of(m_given.begin(), m_given.end(), [&](const PlaceCandidate& o) {
    return o.combination == candidate.combination &&
           (o.at - candidate.at).norm() < 2 * candidate.pixel;
  });
}

bool PlaceOrder::take(const PlaceCandidate& candidate) {
  if (!m_placer.m_sights.empty()) {
    ++m_num_sights;
    if (!meets_sights(candidate)) return false;
  }
  m_given.push_back(candidate);
  return true;
}

std::optional<PlaceCandidate> PlaceOrder::next_of_these() {
  while (!m_first.empty() && m_num_sights < kMaxSights) {
    const PlaceCandidate candidate = m_first.back();
    m_first.pop_back();
    if (!is_close(candidate) && take(candidate)) return candidate;
  }
  while (m_num_sights < kMaxSights) {
    auto candidate = pop();
    if (!candidate) break;
    if (!is_close(*candidate) && fits(*candidate) && take(*candidate)) return candidate;
  }
  return std::nullopt;
}

std::optional<PlaceCandidate> PlaceOrder::next() {
  if (auto candidate = next_of_these()) return candidate;
  // All other turns are tried when the few have given nothing.
  if (!m_has_more) return std::nullopt;
  m_has_more = false;
  add_turns(false);
  return next_of_these();
}

}  // namespace trivet
