#include "ops/arrange/arrangement.h"

#include "core/base/quoted.h"

namespace trivet {
namespace {

// By the numbers of the kinds; the other is an object or the floor.
constexpr const char* kWithOther[] = {TRIVET_SENTENCE("%1 on %2"),
                                      TRIVET_SENTENCE("%1 in %2"),
                                      TRIVET_SENTENCE("%1 against %2"),
                                      TRIVET_SENTENCE("%1 near %2"),
                                      TRIVET_SENTENCE("%1 left_of %2"),
                                      TRIVET_SENTENCE("%1 right_of %2"),
                                      TRIVET_SENTENCE("%1 in_front_of %2"),
                                      TRIVET_SENTENCE("%1 behind %2"),
                                      TRIVET_SENTENCE("%1 facing %2"),
                                      TRIVET_SENTENCE("%1 away %2"),
                                      TRIVET_SENTENCE("%1 aligned %2"),
                                      TRIVET_SENTENCE("%1 parallel %2"),
                                      TRIVET_SENTENCE("%1 perpendicular %2"),
                                      TRIVET_SENTENCE("%1 same %2"),
                                      TRIVET_SENTENCE("%1 centred %2"),
                                      TRIVET_SENTENCE("%1 within %2"),
                                      TRIVET_SENTENCE("%1 at %2"),
                                      TRIVET_SENTENCE("%1 symmetric %2"),
                                      TRIVET_SENTENCE("%1 at_edge %2"),
                                      TRIVET_SENTENCE("%1 under %2"),
                                      TRIVET_SENTENCE("%1 in view of %2"),
                                      TRIVET_SENTENCE("%1 in reach of %2")};
constexpr const char* kOfMany[] = {
    TRIVET_SENTENCE("row of %1 things on %2"), TRIVET_SENTENCE("grid of %1 things on %2"),
    TRIVET_SENTENCE("circle of %1 things on %2"), TRIVET_SENTENCE("facings of %1 things on %2"),
    TRIVET_SENTENCE("line of %1 things on %2")};
constexpr const char* kOfOne[] = {
    TRIVET_SENTENCE("row of 1 thing on %1"), TRIVET_SENTENCE("grid of 1 thing on %1"),
    TRIVET_SENTENCE("circle of 1 thing on %1"), TRIVET_SENTENCE("facings of 1 thing on %1"),
    TRIVET_SENTENCE("line of 1 thing on %1")};

// Without another object.
const char* alone(RelationKind kind) {
  switch (kind) {
    case RelationKind::Facing:
      return TRIVET_SENTENCE("%1 facing its point");
    case RelationKind::Away:
      return TRIVET_SENTENCE("%1 away its point");
    case RelationKind::Within:
      return TRIVET_SENTENCE("%1 within its region");
    case RelationKind::View:
      return TRIVET_SENTENCE("%1 in view of its point");
    case RelationKind::Reach:
      return TRIVET_SENTENCE("%1 in reach of its point");
    default:
      return TRIVET_SENTENCE("%1 at its point");
  }
}

}  // namespace

const char* to_string(RelationKind kind) {
  constexpr const char* kNames[] = {
      "on",      "in",     "against", "near",      "left_of",  "right_of",      "in_front_of",
      "behind",  "facing", "away",    "aligned",   "parallel", "perpendicular", "same",
      "centred", "within", "at",      "symmetric", "at_edge",  "under",         "view",
      "reach"};
  return kNames[static_cast<int>(kind)];
}

const char* to_string(Side side) {
  constexpr const char* kNames[] = {"front", "back", "left", "right"};
  return kNames[static_cast<int>(side)];
}

Sentence Relation::text() const {
  const Sentence to = b == "floor" ? Sentence("the floor") : Sentence(quoted(b));
  return b.empty() ? say(alone(kind), quoted(a))
                   : say(kWithOther[static_cast<int>(kind)], quoted(a), to);
}

Sentence Pattern::text() const {
  const Sentence support = on == "floor" ? Sentence("the floor") : Sentence(quoted(on));
  const int k = static_cast<int>(kind);
  return things.size() == 1 ? say(kOfOne[k], support) : say(kOfMany[k], things.size(), support);
}

Sentence Zone::text() const { return say("zone %1 of %2", quoted(name), quoted(object)); }

}  // namespace trivet
