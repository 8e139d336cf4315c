// Tells which links gravity would move in their joints.
#pragma once

#include <span>

#include "core/io/foreign/scene.h"

namespace trivet {

/// Adds a note if the weights of the bodies would slide or turn the joint that moves them.
void note_if_gravity_moves(const ForeignJoint& joint, std::span<const ForeignBody* const> bodies,
                           std::vector<Sentence>& notes);

}  // namespace trivet
