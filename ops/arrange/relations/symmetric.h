#pragma once

#include "ops/arrange/relations/field.h"

namespace trivet::relations {

/// a stands where the mirror image of b does, at a vertical plane.
struct Symmetric : AnyKind {
  static constexpr const char* kName = "symmetric";
  static constexpr const char* kHelp =
      "a stands, and turns, as the mirror image of b does: at the plane between left and right of "
      "an object that stands already, or at the vertical plane through a point along an axis; "
      "tolerance 1 cm by default, and 2 degrees.";
  static constexpr const char* kText = TRIVET_SENTENCE("%1 symmetric %2");
  static constexpr double kUsualTolerance = 0.01;
  static std::vector<Field<Symmetric>> fields();

  double cost(const Terms& r, const Outline& a, const Outline* b) const;
  std::vector<HalfPlane> half_planes(const Terms& r, const Placed& both, double slack) const;
  std::vector<Rotation> turns(const Outline& moving, const Outline& other) const;
  void extend(Aabb& box) const;
  const std::string* about() const { return middle.empty() ? nullptr : &middle; }
  /// About the plane between its left and its right.
  void set_about(const Outline& outline);
  static std::vector<Way> ways() {
    return {{{"about"}, {"point", "axis"}}, {{"point", "axis"}, {"about"}}};
  }
  const char* wrong(const Terms& r, const IsGiven& is_given) const;

  std::string middle;         // object that stands already; its middle plane, left to right
  std::optional<Vec2> point;  // on the plane
  Vec2 axis = Vec2::UnitY();  // unit, along the plane

 private:
  Vec2 mirrored_direction(const Vec2& v) const { return 2 * v.dot(axis) * axis - v; }
  Vec2 mirrored_point(const Vec2& p) const { return *point + mirrored_direction(p - *point); }
};

}  // namespace trivet::relations
