#include "ops/arrange/arrangement.h"

#include "core/base/quoted.h"

namespace trivet {
namespace {

constexpr const char* kOfAnyKind = TRIVET_SENTENCE("%1 %2 %3");
constexpr const char* kOfMany[] = {
    TRIVET_SENTENCE("row of %1 objects on %2"), TRIVET_SENTENCE("grid of %1 objects on %2"),
    TRIVET_SENTENCE("circle of %1 objects on %2"), TRIVET_SENTENCE("facings of %1 objects on %2"),
    TRIVET_SENTENCE("line of %1 objects on %2")};
constexpr const char* kOfOne[] = {
    TRIVET_SENTENCE("row of 1 object on %1"), TRIVET_SENTENCE("grid of 1 object on %1"),
    TRIVET_SENTENCE("circle of 1 object on %1"), TRIVET_SENTENCE("facings of 1 object on %1"),
    TRIVET_SENTENCE("line of 1 object on %1")};

}  // namespace

Sentence Relation::text() const {
  // Each kind of relation has a sentence with and one without a second object.
  const Sentence to = b == "floor" ? Sentence("the floor") : Sentence(quoted(b));
  return std::visit(
      [&](const auto& k) {
        if (b.empty()) return say(k.kAlone, quoted(a));
        if (k.kText) return say(k.kText, quoted(a), to);
        return say(kOfAnyKind, quoted(a), std::string(k.kName), to);
      },
      kind);
}

Sentence Pattern::text() const {
  const Sentence support = on == "floor" ? Sentence("the floor") : Sentence(quoted(on));
  const int k = static_cast<int>(kind);
  return things.size() == 1 ? say(kOfOne[k], support) : say(kOfMany[k], things.size(), support);
}

Sentence Zone::text() const { return say("zone %1 of %2", quoted(name), quoted(object)); }

}  // namespace trivet
