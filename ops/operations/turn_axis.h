// Axis of a TURN, from a contact [Shinya 1995, Fig. 5]; for editors, too.
#pragma once

#include <array>

#include "core/scene/scene.h"
#include "ops/operations/turn.h"

namespace trivet {

struct TurnAxis {
  Vec3 centre = Vec3::Zero();      // a point on the axis, world
  Vec3 direction = Vec3::UnitZ();  // unit; the turn is right-handed
};

/// True if a TURN that is not told which contact holds `a` rather than `b`, links of one object:
/// those that support before others, then those with more contact, then those that are more level.
bool holds_more(const ObjectContact& a, const ObjectContact& b);

/// The centre of a contact: of its hull's area, of its line, of its points.
Vec3 centre_of(const Contact& contact);

/// The ends of a line contact; of an area the edge of its hull that is nearest to `point`.
/// @param contact  its hull has two points at least.
std::array<Vec3, 2> held_line(const Contact& contact, const Vec3& point);

/// The contact point that is nearest to `point`.
Vec3 held_point(const Contact& contact, const Vec3& point);

/// @param contact  of `object`, where it stands; for About::Line its hull has two points at least.
TurnAxis turn_axis(const Object& object, const Contact& contact, const TurnOperation& o);

}  // namespace trivet
