#include "ops/arrange/placer.h"

#include <algorithm>
#include <cmath>

#include "ops/arrange/noise.h"
#include "ops/arrange/zones.h"
#include "ops/detect/detector.h"
#include "ops/operations/moving_group.h"

namespace trivet {
namespace {

constexpr int kTurns = 8;  // about z, where no relation asks for any
constexpr double kTemperature = 0.2;
constexpr double kNogoodRadius = 6e-3;  // metres
constexpr size_t kMaxCandidates = 64;

std::uint64_t counter(std::uint64_t seed, size_t combination, size_t place) {
  return scrambled(scrambled(seed ^ scrambled(combination)) ^ place);
}

}  // namespace

Placer::Placer(World& world, size_t thing, std::uint64_t seed)
    : m_world(world), m_thing(thing), m_seed(seed), m_clearance(world.clearance(model())) {
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

// Those that the thing asks for itself, else its hard relations, else all round; soft relations add
// theirs.
std::vector<Rotation> Placer::turns(const Rotation& rest) const {
  std::vector<Rotation> out;
  for (const double yaw : model().thing->yaws_deg) out.push_back(turned_about_z(yaw));
  if (!out.empty()) return out;
  const Outline outline = m_world.outline(model(), {rest, Vec3::Zero()});
  std::vector<Rotation> soft;
  bool faces = false;
  for (const Relation* r : m_relations) {
    faces = faces || wanted_front(*r, outline, partner(*r)) != Vec2::Zero();
    if (!partner(*r)) continue;
    // A side of b that is against a turns with b.
    const bool turns_with_a = r->kind != RelationKind::Against || r->a == name();
    if (!turns_with_a) continue;
    for (const Rotation& turn : turns_asked_for(*r, outline, *partner(*r)))
      (r->is_hard() ? out : soft).push_back(turn);
    if (!out.empty()) return out;
  }
  const int count = faces ? kFacingTurns : kTurns;
  for (int i = 0; i < count; ++i) out.push_back(turned_about_z(360.0 * i / count));
  out.insert(out.end(), soft.begin(), soft.end());
  return out;
}

// The centre of mass over the landing; on the unbounded floor, not far from everything.
ConvexRegion Placer::window(const Landing& landing, const Outline& outline) const {
  Vec2 lower = landing.lower, upper = landing.upper;
  if (!(lower.x() > -kInfinity)) {
    Aabb box = m_world.scene().box();
    box.extend(Vec3::Zero());
    double more = 0;
    for (const ThingModel& thing : m_world.things()) more += std::sqrt(thing.area);
    for (const Relation* r : m_relations) {
      if (r->point) box.extend(Vec3(r->point->x(), r->point->y(), 0));
      for (const Vec2& p : r->region) box.extend(Vec3(p.x(), p.y(), 0));
      if (r->upper < kInfinity) more = std::max(more, r->upper);
    }
    const double size = outline.width(Vec2::UnitX()) + outline.width(Vec2::UnitY());
    lower = box.lower.head<2>() - Vec2::Constant(more + size);
    upper = box.upper.head<2>() + Vec2::Constant(more + size);
  }
  return {lower - outline.mass_centre, upper - outline.mass_centre};
}

void Placer::clip(Combination& combination) const {
  for (const Relation* r : m_relations) {
    if (!r->is_hard()) continue;
    for (const HalfPlane& h : half_planes(*r, combination.outline, partner(*r), r->a == name()))
      combination.region.clip(h);
  }
}

void Placer::combine() {
  for (const Rotation& rest : model().rests) {
    const Outline lying = m_world.outline(model(), {rest, Vec3::Zero()});
    std::string why_none;
    const auto landings = m_world.landings(model(), lying.top - lying.bottom, why_none);
    for (const Rotation& turn : turns(rest)) {
      Combination combination;
      combination.rotation = (turn * rest).normalized();
      combination.outline = m_world.outline(model(), {combination.rotation, Vec3::Zero()});
      for (const Landing& landing : landings) {
        combination.landing = landing;
        combination.region = window(landing, combination.outline);
        clip(combination);
        if (!combination.region.empty()) m_combinations.push_back(combination);
      }
    }
  }
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

std::vector<PlaceCandidate> Placer::candidates(Obstacles which,
                                               const std::vector<Vec2>& nogoods) const {
  std::vector<PlaceCandidate> all;
  for (size_t c = 0; c < m_combinations.size(); ++c) {
    const Combination& combination = m_combinations[c];
    const PlaceField field = this->field(combination);
    const std::vector<char> clear = this->clear(field, combination, which);
    for (size_t i = 0; i < field.size(); ++i) {
      if (!clear[i] || !field.is_over_support(i)) continue;
      const Vec2& at = field.at(i);
      const auto near = [&](const Vec2& p) { return (p - at).norm() < kNogoodRadius; };
      if (std::any_of(nogoods.begin(), nogoods.end(), near)) continue;
      const Outline outline = moved(combination.outline, at);
      if (!meets_hard(outline, kFacingSlackDeg)) continue;
      PlaceCandidate candidate{0, energy(outline), c, at, field.pixel()};
      candidate.key = candidate.energy - kTemperature * gumbel_noise(counter(m_seed, c, i));
      all.push_back(candidate);
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const PlaceCandidate& a, const PlaceCandidate& b) { return a.key < b.key; });
  std::vector<PlaceCandidate> out;
  for (const PlaceCandidate& candidate : all) {
    const auto close = [&](const PlaceCandidate& o) {
      return o.combination == candidate.combination &&
             (o.at - candidate.at).norm() < 2 * candidate.pixel;
    };
    if (std::any_of(out.begin(), out.end(), close)) continue;
    out.push_back(candidate);
    if (out.size() == kMaxCandidates) break;
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
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace trivet
