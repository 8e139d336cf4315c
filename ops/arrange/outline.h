// An object as relations see it: its outline from above, its centre and its front.
#pragma once

#include <vector>

#include "core/scene/object.h"
#include "ops/arrange/angles.h"

namespace trivet {

struct Outline {
  std::vector<Vec2> hull;      // counter-clockwise
  Vec2 centre = Vec2::Zero();  // of its rectangle along front and right
  Vec2 mass_centre = Vec2::Zero();
  Vec2 front = -Vec2::UnitY();  // unit
  double bottom = 0, top = 0;   // z

  /// As one who stands in front of it and looks at it sees it.
  Vec2 right() const { return quarter_turned(front); }
  double width(const Vec2& direction) const;
};

/// Vertices of an object's convex hull in the model's frame; all vertices of a flat one. The first
/// costs O(n log n), outlines what is on the hull.
std::vector<Vec3> hull_points(const Shape& shape);

/// @param points  hull_points() of the object's shape, or more of it.
/// @param front  in the model's frame after its up axis. Of an object that lies on its front or
///   back, which has none, the turn of the smallest rotation into that pose counts.
Outline outline_of(const std::vector<Vec3>& points, const Object& object, const Pose& pose,
                   const Vec3& front);

/// Points in the outline's hull, lowest or highest: outlines of the same pose
/// turned about z need no others.
std::vector<Vec3> rim_of(const std::vector<Vec3>& points, const Object& object, const Pose& pose,
                         const Outline& outline);

Outline moved(Outline outline, const Vec2& by);

}  // namespace trivet
