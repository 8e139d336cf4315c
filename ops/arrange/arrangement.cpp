#include "ops/arrange/arrangement.h"

#include "core/base/count_of.h"
#include "core/base/quoted.h"

namespace trivet {

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

std::string Relation::text() const {
  std::string out = quoted(a) + " " + to_string(kind);
  if (!b.empty()) out += " " + (b == "floor" ? "the floor" : quoted(b));
  if (kind == RelationKind::View || kind == RelationKind::Reach)
    return quoted(a) + (kind == RelationKind::View ? " in view" : " in reach") + " of " +
           (b.empty() ? "its point" : quoted(b));
  if (b.empty() && kind == RelationKind::Within) out += " its region";
  if (b.empty() && kind != RelationKind::Within) out += " its point";
  return out;
}

std::string Pattern::text() const {
  constexpr const char* kNames[] = {"row", "grid", "circle", "facings", "line"};
  return std::string(kNames[static_cast<int>(kind)]) + " of " + count_of(things.size(), "thing") +
         " on " + (on == "floor" ? "the floor" : quoted(on));
}

std::string Zone::text() const { return "zone " + quoted(name) + " of " + quoted(object); }

}  // namespace trivet
