// Stable attitudes of objects, and how far an object is from them. Private.
#pragma once

#include <utility>
#include <vector>

#include "core/scene/object.h"
#include "ops/arrange/shape_facts.h"

namespace trivet {

/// Stable attitudes of an object as the directions, in its own frame (z up, metres), that point
/// down in them; unit.
std::vector<Vec3> downs_of(const Object& object, ShapeFacts& facts);
/// The nearest of these to the attitude, and degrees to it; -1 without any.
std::pair<int, double> nearest_down(const std::vector<Vec3>& downs, const Rotation& rotation);
/// The object's pose turned to the nearest of these, which must not be empty, about the middle of
/// its box.
Pose levelled(const Object& object, const std::vector<Vec3>& downs);

}  // namespace trivet
