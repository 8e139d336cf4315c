// A thing's trial at a candidate: refined, PUT, and judged where it came to rest.
#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/place_order.h"
#include "ops/arrange/relations.h"
#include "ops/arrange/steadiness.h"
#include "ops/arrange/zones.h"
#include "ops/free_places/distance_query.h"
#include "ops/operations/inside.h"

namespace trivet {
namespace {

constexpr int kHalvings = 8;

bool touches(const Object& object, ObjectId other) {
  return std::any_of(object.contacts.begin(), object.contacts.end(),
                     [&](const ObjectContact& c) { return c.with == Support(other); });
}

}  // namespace

SightTrial Placer::sight_trial(const PlaceCandidate& candidate, Obstacles which) const {
  const Rotation& rotation = m_combinations[candidate.combination].rotation;
  return {m_world,
          static_cast<int>(m_thing),
          {rotation, Vec3(candidate.at.x(), candidate.at.y(), candidate.start_z)},
          which == Obstacles::Immovable};
}

// Downhill in the soft costs, within a pixel.
Vec2 Placer::refined(const PlaceCandidate& candidate) const {
  const Combination& c = m_combinations[candidate.combination];
  Vec2 at = candidate.at;
  if (!(candidate.energy > 0)) return at;
  PlaceCosts costs(*this, c);
  costs.move_to(at);
  double best = costs.energy(), step = 0.5 * candidate.pixel;
  // The step is halved after each round of four directions.
  for (int k = 0; k < kHalvings; ++k, step *= 0.5)
    for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
      const Vec2 next = c.region.nearest(at + step * d);
      costs.move_to(next);
      const double there = costs.energy();
      if (!(there < best) || !costs.meets_hard()) continue;
      best = there;
      at = next;
    }
  return at;
}

Rotation Placer::turned_to_face(const PlaceCandidate& candidate, const Vec2& at) const {
  const Combination& c = m_combinations[candidate.combination];
  for (const Relation* r : m_relations) {
    if (r->a != name()) continue;
    const Outline outline = moved(c.outline, at);
    const Vec2 wanted = wanted_front(*r, outline, partner(*r));
    // A thing with a yaw of its own keeps it.
    if (wanted != Vec2::Zero() && model().thing->yaws_deg.empty())
      return (relations::turn_between(outline.front, wanted) * c.rotation).normalized();
  }
  return c.rotation;
}

std::optional<Sentence> Placer::put(const PlaceCandidate& candidate, OperationResult& result) {
  const Combination& c = m_combinations[candidate.combination];
  const Vec2 at = refined(candidate);
  PutOperation put;
  put.tries = 1;
  put.object = name();
  put.start.rotation = turned_to_face(candidate, at);
  const double height = c.landing.start_z - c.outline.bottom + m_clearance;
  put.start.translation = Vec3(at.x(), at.y(), height);
  // PUT decides: the scene keeps the thing only if it comes to rest as it was meant.
  World::Trial trial(m_world);
  result = m_world.perform(put);
  if (!result.ok()) return sentence_of(*result.refusal);
  if (auto why = push_to_contact(result)) return why;
  if (auto why = judge(c, put.start.rotation, result)) return why;
  trial.commit();
  return std::nullopt;
}

// Over what is left of each gap that is to be 0: walls that stop it sooner are judged by the cost.
std::optional<Sentence> Placer::push_to_contact(OperationResult& result) {
  for (const Relation* r : m_relations) {
    if (!closes_gap(*r) || r->a != name()) continue;
    const Outline outline = m_world.outline(model(), m_world.object(model()).pose);
    const Vec2 d = direction_of(*r, outline, *partner(*r));
    // The gap that PUT has left is closed by PUSH, which stops at contact.
    const double gap = -extent(outline.hull, -d) - extent(partner(*r)->hull, d);
    if (!(gap > m_clearance)) continue;
    PushOperation push;
    push.object = name();
    push.direction = -d;
    push.distance = gap;
    push.step_up = push.step_down = 0;
    push.slide = false;
    const OperationResult pushed = m_world.perform(push);
    result.milliseconds += pushed.milliseconds;
    result.num_motions += pushed.num_motions;
    result.num_queries += pushed.num_queries;
    result.num_face_pairs += pushed.num_face_pairs;
    if (!pushed.ok()) return sentence_of(*pushed.refusal);
    if (!pushed.gave_way.empty()) return say("%1 gives way", quoted(pushed.gave_way.front().name));
  }
  return std::nullopt;
}

std::optional<Sentence> Placer::judge(const Combination& combination, const Rotation& rotation,
                                      const OperationResult& result) const {
  // The checks go from cheap to costly; the first that fails is the reason given.
  if (!result.gave_way.empty()) return say("%1 gives way", quoted(result.gave_way.front().name));
  const Object& object = m_world.object(model());
  const Vec3 up = object.pose.rotation.matrix().row(2), wanted = rotation.matrix().row(2);
  const bool may_tip = model().thing->pose.kind == PoseChoice::Kind::Free;
  if (!may_tip && angle_between_deg(up, wanted) > kMostTiltDeg)
    return say("%1 tips", quoted(name()));
  if (auto why = judge_supports(combination)) return why;
  if (auto why = taken_zone(m_world, model())) return why;
  const Outline outline = m_world.outline(model(), object.pose);
  for (const Relation* r : m_relations)
    if (r->is_hard() && !(cost(*r, outline) <= 1))
      return say("where it comes to rest, not: %1", r->text());
  if (auto why = broken_sight(m_world)) return why;
  if (auto why = unsteady(m_world, model())) return why;
  return judge_distances(combination);
}

std::optional<Sentence> Placer::judge_supports(const Combination& combination) const {
  const auto& supports = combination.landing.supports;
  const Object& thing = m_world.object(model());
  bool carried = false;
  // Only supports that were asked for may carry it.
  for (const ObjectContact& entry : thing.contacts) {
    const bool asked = std::count(supports.begin(), supports.end(), entry.with) > 0;
    carried = carried || (asked && holds_up(entry));
    if (!asked && holds_up(entry))
      return say("%1 comes to rest on %2", quoted(name()),
                 entry.with.is_floor()
                     ? Sentence("the floor")
                     : Sentence(quoted(m_world.scene().at(entry.with.object()).name)));
  }
  if (!carried) return say("%1 does not rest on what it is to rest on", quoted(name()));
  return judge_inside(thing);
}

std::optional<Sentence> Placer::judge_inside(const Object& thing) const {
  const Relation* const support = m_world.support_of(model());
  if (!support || support->b == "floor" || !support->as<relations::In>()) return std::nullopt;
  const ObjectId container = *m_world.scene().find(support->b);
  // Contents alone may carry it above the rim.
  if (touches(thing, container) && !is_inside(thing, m_world.scene().at(container)))
    return say("%1 comes to rest on the rim of %2", quoted(name()), quoted(support->b));
  return std::nullopt;
}

std::optional<Sentence> Placer::judge_distances(const Combination& combination) const {
  const Scene& scene = m_world.scene();
  const Body body = body_of(scene.at(model().id));
  for (const ObjectId id : m_world.standing()) {
    const auto& supports = combination.landing.supports;
    // Boxes tell most apart before surfaces are measured.
    if (id == model().id || std::count(supports.begin(), supports.end(), Support(id))) continue;
    const double keep = m_world.keep(name(), scene.at(id).name);
    if (keep > 0 && overlaps(scene.world_box(id), body.world_box, keep) &&
        nearer_than(keep, body, body_of(scene.at(id))))
      return say("%1 comes too near to %2", quoted(name()), quoted(scene.at(id).name));
  }
  return std::nullopt;
}

}  // namespace trivet
