#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// Turned about z to b's centre, or to a point, or from it.
struct Turned : AnyKind {
  static constexpr const char* kHelp =
      "a's front, or back, is turned to b, or to a point; tolerance in degrees, default 5.";
  static constexpr double kUsualTolerance = 5;
  static constexpr Other kOther = Other::Optional;
  static constexpr bool kIsInDegrees = true, kFaces = true;

  /// Unit, from a; a's front where it is at the point.
  Vec2 towards(const Outline& a, const Outline* b, double sign) const;
  static std::vector<Way> ways() { return {{{"b"}, {"point"}}, {{"point"}, {"b"}}}; }
  const char* wrong(const Terms& r, const IsGiven&) const;
  void extend(Aabb& box) const;

  std::optional<Vec2> point;
};

/// a's front points there.
struct Facing : Turned {
  static constexpr const char* kName = "facing";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 facing %2");
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 facing its point");
  static std::vector<Field<Facing>> fields();

  Vec2 front(const Outline& a, const Outline* b) const { return towards(a, b, 1); }
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return angle_between_deg(a.front, front(a, b)) / r.tolerance;
  }
};

/// a's back does.
struct Away : Turned {
  static constexpr const char* kName = "away";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 away %2");
  static constexpr const char* kAlone = TRIVET_SENTENCE("%1 away its point");
  static std::vector<Field<Away>> fields();

  Vec2 front(const Outline& a, const Outline* b) const { return towards(a, b, -1); }
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return angle_between_deg(a.front, front(a, b)) / r.tolerance;
  }
};

}  // namespace trivet::relations
