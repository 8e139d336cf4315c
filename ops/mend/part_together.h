// Objects in each other parted where they are, all at once. Private.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ops/base/deadline.h"
#include "ops/placement/depth.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Poses at which these objects are free of each other, of what is in the scene and of its floor,
/// by the shifts with the least sum of squares. Pairs part by their exact depths; where that leads
/// into others, these part, too, in rounds. Some may still be in each other after the last one.
/// @param members  none of them in the scene. @param air  metres between what is parted.
/// @param is_over  asked before each round and object.
std::vector<Placement> part_together(const Scene& scene, std::vector<Placement> members, double air,
                                     const IsOver& is_over = {});

/// A member in another one, or in what stays.
struct MemberCrossing {
  size_t a = 0;
  std::optional<size_t> b;  // nothing: what stays
  Support with;             // what `a` is in
  Depth depth;              // of `a`
};

/// False of two members that are known to be apart.
using MayMeet = std::function<bool(const Placement&, const Placement&)>;

/// All of them, by members, or those that were found in time. @param worlds  of the members, about
/// `origin`.
std::vector<MemberCrossing> crossings_of(const Scene& scene, std::span<const Placement> members,
                                         const std::vector<ObjectInWorld>& worlds,
                                         const Vec3& origin, const MayMeet& may_meet = {},
                                         const IsOver& is_over = {});
std::vector<MemberCrossing> crossings_of(const Scene& scene, std::span<const Placement> members,
                                         const MayMeet& may_meet = {}, const IsOver& is_over = {});

}  // namespace trivet
