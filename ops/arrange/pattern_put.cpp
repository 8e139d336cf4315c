#include "ops/arrange/pattern_put.h"

#include "core/base/quoted.h"
#include "ops/arrange/angles.h"
#include "ops/arrange/sights.h"
#include "ops/arrange/steadiness.h"
#include "ops/arrange/zones.h"

namespace trivet {
namespace {

constexpr double kMostShift = 1e-3;  // metres, of a thing at rest from its slot

Conflict conflict_of(const Pattern& pattern, const Sentence& text, double missing) {
  Conflict out;
  out.thing = in_english(pattern.text());
  out.objects = pattern.things;
  out.objects.push_back(pattern.on);
  out.text = text;
  out.constraints = {pattern.text()};
  if (missing > 0) out.missing = missing;
  return out;
}

std::optional<Sentence> judge_slot(const World& world, const Slot& slot, const Pattern& pattern,
                                   const OperationResult& result) {
  const ThingModel& thing = world.things()[slot.thing];
  const std::string who = quoted(thing.thing->object);
  // A slot is kept only if the thing stays where the pattern has it: upright, unmoved, and on the
  // support.
  if (!result.ok()) return sentence_of(*result.refusal);
  if (!result.gave_way.empty()) return say("%1 makes others give way", who);
  const Object& object = world.object(thing);
  const Vec3 up = object.pose.rotation.matrix().row(2);
  const Vec3 wanted = slot.start.rotation.matrix().row(2);
  if (angle_between_deg(up, wanted) > kMostTiltDeg) return say("%1 tips", who);
  const Vec3 shift = object.pose.translation - slot.start.translation;
  if (shift.head<2>().norm() > kMostShift) return say("%1 slides away", who);
  const Support on =
      pattern.on == kFloorName ? Support::floor() : Support(*world.scene().find(pattern.on));
  for (const ObjectContact& entry : object.contacts)
    if (holds_up(entry) && !(entry.with == on))
      return say("%1 does not rest on %2 alone", who, quoted(pattern.on));
  if (auto why = broken_sight(world)) return why;
  return taken_zone(world, thing);
}

}  // namespace

std::optional<Conflict> put_pattern(World& world, const Pattern& pattern, std::uint64_t seed,
                                    std::vector<PlacedSlot>& placed) {
  // All slots follow from lengths alone: the pattern does not fit, or has them all.
  const Slots slots = slots_of(world, pattern, seed);
  if (!slots.why_not.empty()) return conflict_of(pattern, slots.why_not, slots.missing);
  World::Trial trial(world);
  placed.reserve(slots.slots.size());
  // Each thing is put like any other; the first that fails takes the whole pattern back.
  for (const Slot& slot : slots.slots) {
    PutOperation put;
    put.tries = 1;
    put.object = world.things()[slot.thing].thing->object;
    put.start = slot.start;
    placed.push_back({slot.thing, world.perform(put)});
    if (const auto why = judge_slot(world, slot, pattern, placed.back().result))
      return conflict_of(pattern, say("%1: %2", pattern.text(), *why), 0);
  }
  // Carriers are judged with all of them: things may balance each other.
  for (const Slot& slot : slots.slots)
    if (const auto why = unsteady(world, world.things()[slot.thing]))
      return conflict_of(pattern, say("%1: %2", pattern.text(), *why), 0);
  trial.commit();
  return std::nullopt;
}

}  // namespace trivet
