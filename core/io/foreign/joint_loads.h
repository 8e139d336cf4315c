// Tells which links gravity would move in their joints.
#pragma once

#include <span>

#include "core/io/foreign/scene.h"

namespace trivet {

/// Adds a note if the weights of the bodies would slide or turn the joint that moves them.
/// @param friction  that holds it: newtons or newton metres.
void note_if_gravity_moves(const ForeignJoint& joint, std::span<const ForeignBody* const> bodies,
                           double friction, std::vector<Sentence>& notes);

}  // namespace trivet
