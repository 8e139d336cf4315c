// Projection volume of a motion: the box in which z-lists see the moving objects [Shinya 1995, 5.1
// and Fig. 15].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/contact/body.h"
#include "core/motion/motion.h"

namespace trivet::edit {

/// Edges of the volume as lines; world, metres.
using ProjectionVolume = std::vector<std::array<Vec3, 2>>;

/// Edges of the box around the moving bodies, along their motion; of a turn, of the part of a ring
/// about its axis. In the image plane of z-lists (core/candidates/zlist_frame.h), before it is
/// restricted to what may be in the way. Empty: no body has faces.
/// @param moving  as one body, where the motion begins.
ProjectionVolume projection_volume(std::span<const Body> moving, const Motion& motion);

}  // namespace trivet::edit
