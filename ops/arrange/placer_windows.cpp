// Rotations of a thing, and where it may be in each.
#include <algorithm>
#include <cmath>

#include "ops/arrange/noise.h"
#include "ops/arrange/placer.h"

namespace trivet {
namespace {

constexpr int kTurns = 8;      // about z, where no relation asks for any
constexpr int kAnyTurns = 16;  // of things that may be turned at will

}  // namespace

// Turns that the thing asks for itself, else its hard relations, else all round; soft relations add
// theirs.
std::vector<Rotation> Placer::turns(const Rest& rest) const {
  std::vector<Rotation> out;
  for (const double yaw : model().thing->yaws_deg) out.push_back(turned_about_z(yaw));
  if (!out.empty()) return out;
  const Outline& outline = rest.outline;
  std::vector<Rotation> soft;
  bool faces = false;
  // The first hard relation that asks for directions decides the turns; those that soft ones wish
  // are added.
  for (const Relation* r : m_relations) {
    faces = faces || wanted_front(*r, outline, partner(*r)) != Vec2::Zero();
    if (!partner(*r)) continue;
    // A side of b that is against a turns with b.
    const bool turns_with_a = !turns_only_a(*r) || r->a == name();
    if (!turns_with_a) continue;
    for (const Rotation& turn : turns_asked_for(*r, outline, *partner(*r)))
      (r->is_hard() ? out : soft).push_back(turn);
    if (!out.empty()) return out;
  }
  // Without any, turns go round evenly, from an angle by the seed if any will do.
  const bool any = model().thing->any_yaw;
  const int count = faces ? kFacingTurns : any ? kAnyTurns : kTurns;
  const double first = any && !faces ? double(scrambled(m_seed) >> 12) * 0x1p-52 * 360 / count : 0;
  for (int i = 0; i < count; ++i) out.push_back(turned_about_z(first + 360.0 * i / count));
  out.insert(out.end(), soft.begin(), soft.end());
  return out;
}

// The centre of mass over the landing; on the unbounded floor, not far from everything.
ConvexRegion Placer::window(const Landing& landing, const Outline& outline) const {
  Vec2 lower = landing.lower, upper = landing.upper;
  // The floor has no end: the window reaches as far as relations and sizes may ask.
  if (!(lower.x() > -kInfinity)) {
    Aabb box = m_world.scene().box();
    box.extend(Vec3::Zero());
    double more = 0;
    for (const ThingModel& thing : m_world.things()) more += std::sqrt(thing.area);
    for (const Relation* r : m_relations) {
      std::visit([&](const auto& kind) { kind.extend(box); }, r->kind);
      const double length = std::visit([](const auto& kind) { return kind.length(); }, r->kind);
      if (length < kInfinity) more = std::max(more, length);
    }
    for (const KeepApart& keep : m_world.arrangement().keeps) more = std::max(more, keep.distance);
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

// Takes a part, by the seed, of a region that is far larger than the thing.
void Placer::narrow(Combination& combination) const {
  const Object& object = m_world.object(model());
  const Body body = body_of(object, {combination.rotation, Vec3::Zero()});
  const double most = PlaceField::largest_window(body.world_box);
  ConvexRegion& region = combination.region;
  if (region.empty() || (region.upper() - region.lower()).maxCoeff() <= most) return;
  // The part's middle is a random mean of the corners, and so inside.
  Vec2 middle = Vec2::Zero();
  double sum = 0;
  for (size_t i = 0; i < region.corners().size(); ++i) {
    const auto bits = scrambled(m_seed ^ scrambled(~(combination.turn << 8 | i)));
    const double weight = (double(bits >> 12) + 1) * 0x1p-52;
    middle += weight * region.corners()[i], sum += weight;
  }
  middle /= sum;
  for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
    region.clip({d, d.dot(middle) + 0.5 * most});
}

// True if no relation asks for a turn, and the thing for none.
bool Placer::turns_are_free() const {
  if (!model().thing->yaws_deg.empty()) return false;
  const Outline& outline = model().rests.front().outline;
  return std::all_of(m_relations.begin(), m_relations.end(), [&](const Relation* r) {
    return wanted_front(*r, outline, partner(*r)) == Vec2::Zero() &&
           (!partner(*r) || turns_asked_for(*r, outline, *partner(*r)).empty());
  });
}

void Placer::combine() {
  m_turns_are_free = m_temperature > 0 && turns_are_free();
  for (const Rest& rest : model().rests) {
    Sentence why_none;
    const double height = rest.outline.top - rest.outline.bottom;
    const auto landings = m_world.landings(model(), height, why_none);
    const std::vector<Rotation> turns = this->turns(rest);
    m_num_turns = std::max(m_num_turns, turns.size());
    for (size_t t = 0; t < turns.size(); ++t) {
      const Rotation& turn = turns[t];
      // Each turn and landing has a region, which hard relations clip; empty ones are dropped.
      Combination combination;
      combination.turn = t;
      combination.rotation = (turn * rest.rotation).normalized();
      combination.outline = m_world.outline(model(), rest, turn);
      for (const Landing& landing : landings) {
        combination.landing = landing;
        combination.region = window(landing, combination.outline);
        clip(combination);
        narrow(combination);
        if (!combination.region.empty()) m_combinations.push_back(combination);
      }
    }
  }
}

}  // namespace trivet
