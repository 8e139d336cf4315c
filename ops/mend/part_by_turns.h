// Objects in each other parted where they are, by shifts and turns. Private.
#pragma once

#include "ops/mend/part_together.h"
#include "ops/mend/small_motions.h"

namespace trivet {

/// Poses at which these objects are free, as part_together() finds them, but turned, too, which
/// takes them less far: each crossing parts where its faces meet. What is left after some rounds is
/// parted by shifts.
/// @param given  none of them in the scene. @param air  metres between what is parted.
/// @param is_over  asked before each round and object: then some may be in each other, too.
std::vector<Placement> part_by_turns(const Scene& scene, const std::vector<Placement>& given,
                                     double air, const IsOver& is_over = {});

/// The condition that a crossing is left.
/// @param gone  the motions at which it was found. @param air  metres beyond.
MotionRow row_out_of(const MemberCrossing& crossing, const std::vector<FreeBody>& bodies,
                     const std::vector<SmallMotion>& gone, double air);

}  // namespace trivet
