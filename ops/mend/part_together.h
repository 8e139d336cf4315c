// Objects in each other parted where they are, all at once. Private.
#pragma once

#include <vector>

#include "ops/placement/neighbourhood.h"

namespace trivet {

/// Poses at which these objects are free of each other, of what is in the scene and of its floor,
/// by the shifts with the least sum of squares. Pairs part by their exact depths; where that leads
/// into others, these part, too, in rounds. Some may still be in each other after the last one.
/// @param members  none of them in the scene. @param air  metres between what is parted.
std::vector<Placement> part_together(const Scene& scene, std::vector<Placement> members,
                                     double air);

}  // namespace trivet
