#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// a's centre is at `point`.
struct At : AnyKind {
  static constexpr const char* kName = "at";
  static constexpr const char* kHelp = "a's centre is here; tolerance 1 cm by default.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 at %2");
  static constexpr double kUsualTolerance = 0.01;
  static constexpr Other kOther = Other::None;
  static std::vector<Field<At>> fields();

  double cost(const Terms& r, const Outline& a, const Outline*) const {
    return (a.centre - *point).norm() / r.tolerance;
  }
  std::vector<HalfPlane> half_planes(const Terms&, const Placed& both, double slack) const {
    return planes_about(*point - both.moving.centre, slack);
  }
  bool is_decided_by_planes() const { return true; }
  void extend(Aabb& box) const {
    if (point) box.extend(Vec3(point->x(), point->y(), 0));
  }

  std::optional<Vec2> point;
};

}  // namespace trivet::relations
