// Rows: objects that stand side by side on one thing. Private.
#pragma once

#include "ops/mend/spread.h"

namespace trivet {

/// Poses near the given ones in which they are free of each other and of what is in the scene.
/// Turns about gravity count as noise if a row lacks room: what is nearly parallel to the thing
/// below becomes so.
/// @param row  none of them in the scene; in contact with what they stand on, or just above.
/// @param tolerance  metres by which poses may be off. @param most_turn_deg  the same of turns.
std::vector<Placement> spread_row(const Scene& scene, std::vector<Placement> row, const Support& on,
                                  double tolerance, double most_turn_deg, ShapeFacts& facts);

/// World position of the middle of an object's own box.
Vec3 middle_of_box(const Object& object, const Pose& pose);

}  // namespace trivet
