#pragma once

#include "ops/arrange/relations/kind.h"

namespace trivet::relations {

/// a's front is b's, but for some turns.
struct Aligning : AnyKind {
  static constexpr const char* kHelp =
      "a's front is b's, but for quarter turns, half turns, a quarter turn to either side, or "
      "none; tolerance in degrees, default 2.";
  static constexpr double kUsualTolerance = 2;
  static constexpr bool kIsInDegrees = true, kTurns = true;
};

/// Degrees between two directions but for turns of this many degrees.
double turned_from(const Vec2& a, const Vec2& b, double period_deg);

/// But for quarter turns.
struct Aligned : Aligning {
  static constexpr const char* kName = "aligned";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 aligned %2");
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return turned_from(a.front, b->front, 90) / r.tolerance;
  }
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const {
    return turns_to(moving, other.front, 1);
  }
};

/// But for half a turn.
struct Parallel : Aligning {
  static constexpr const char* kName = "parallel";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 parallel %2");
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return turned_from(a.front, b->front, 180) / r.tolerance;
  }
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const {
    return turns_to(moving, other.front, 2);
  }
};

/// A quarter turn from it, to either side.
struct Perpendicular : Aligning {
  static constexpr const char* kName = "perpendicular";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 perpendicular %2");
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return turned_from(a.front, quarter_turned(b->front), 180) / r.tolerance;
  }
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const {
    return turns_to(moving, quarter_turned(other.front), 2);
  }
};

/// But for none.
struct Same : Aligning {
  static constexpr const char* kName = "same";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 same %2");
  double cost(const Terms& r, const Outline& a, const Outline* b) const {
    return angle_between_deg(a.front, b->front) / r.tolerance;
  }
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const {
    return turns_to(moving, other.front, 4);
  }
};

}  // namespace trivet::relations
