#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// Parts of kinds that have a beside b, in the direction d from it, at a gap.
/// @param wanted  metres along which both are beside each other, at least.
double beside_cost(const Terms& r, const Gap& gap, const Vec2& d, double wanted, const Outline& a,
                   const Outline& b);
std::vector<HalfPlane> beside_planes(const Terms& r, const Gap& gap, const Vec2& d, double wanted,
                                     const Placed& both, double slack);
double beside_most_apart(const Terms& r, const Gap& gap, const Sizes& sizes);
/// The gap is to be 0: a is pushed to b where it came to rest.
bool closes(const Terms& r, const Gap& gap);

/// a is beside b, on one side, with so much overlap along it.
/// @tparam K  has way(b), the direction from b.
template <class K>
struct Beside : AnyKind, Gap {
  static constexpr const char* kHelp =
      "As seen by one who stands in front of b and looks at it; they overlap across by this part "
      "of the narrower one, default 0.5.";
  static constexpr bool kIsBeside = true;
  static std::vector<Field<K>> fields() {
    return {{"gap", GapForm::Both}, {"overlap", &K::overlap}};
  }

  Vec2 direction(const Outline&, const Outline& b) const { return K::way(b); }
  double wanted(const Outline& a, const Outline& b) const {
    const Vec2 across = quarter_turned(K::way(b));
    return overlap * std::min(a.width(across), b.width(across));
  }
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return beside_cost(r, *this, K::way(*b), wanted(a, *b), a, *b);
  }
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const {
    return beside_planes(r, *this, K::way(both.b()), wanted(both.a(), both.b()), both, slack);
  }
  bool is_decided_by_planes() const { return true; }
  const Gap* gap() const { return this; }
  double most_apart(const Terms& r, const Sizes& sizes) const {
    return beside_most_apart(r, *this, sizes);
  }
  double length() const { return upper; }

  double overlap = 0.5;  // of the narrower of both
};

struct LeftOf : Beside<LeftOf> {
  static constexpr const char* kName = "left_of";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 left_of %2");
  static Vec2 way(const Outline& b) { return -b.right(); }
};

struct RightOf : Beside<RightOf> {
  static constexpr const char* kName = "right_of";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 right_of %2");
  static Vec2 way(const Outline& b) { return b.right(); }
};

struct InFrontOf : Beside<InFrontOf> {
  static constexpr const char* kName = "in_front_of";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 in_front_of %2");
  static Vec2 way(const Outline& b) { return b.front; }
};

struct Behind : Beside<Behind> {
  static constexpr const char* kName = "behind";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 behind %2");
  static Vec2 way(const Outline& b) { return -b.front; }
};

}  // namespace trivet::relations
