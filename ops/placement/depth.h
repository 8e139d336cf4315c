// Depth of an interpenetration: how far one object has to be moved to be free of the other.
#pragma once

#include "ops/placement/verify.h"

namespace trivet {

struct Depth {
  double metres = 0;          // 0: they touch
  Vec3 way = Vec3::Zero();    // unit, of `a`; free after `metres`, but for rounding
  Vec3 point = Vec3::Zero();  // world, where faces meet; of what is inside: of its box's middle
};

/// Least translation of `a` that takes it out of `b`, among those along the axes of the world and
/// the normals of faces that meet: exact where one of these is the shortest way, else a bound from
/// above, a thousandth too large at most. Some hundred exact tests.
Depth depth_of(const ObjectInWorld& a, const ObjectInWorld& b);

/// The same of an object and the floor: exact.
Depth depth_below_floor(const ObjectInWorld& here);

/// Adds depth and point to a refusal that names what interpenetrates: numbers depth, x, y, z.
/// @param given  an object and the pose that was asked for; all others are where the scene has
/// them.
void add_depth(const Scene& scene, const Placement& given, Refusal& refusal);

}  // namespace trivet
