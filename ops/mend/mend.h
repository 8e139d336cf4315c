// The nearest true scene that keeps what was meant. Start here.
//
//   intent     what stands on and in what, from the poses as they are (intent.h)
//   nominal    level, in contact with what carries it, along with what moved that
//   place      bottom up: PUT from there, then from places around, at the least cost
#pragma once

#include <string>
#include <vector>

#include "ops/mend/intent.h"
#include "ops/mend/settle_free.h"

namespace trivet {

struct MendOptions : SettleSceneOptions {
  double tolerance = 0;  // metres by which poses may be off; 0: found from them
  int most_tries = 48;   // starts of one object
};

/// A true object stays, to the bit, unless what carries it moves. Every other free object goes to
/// the nearest place found where it passes through nothing, rests, and is carried by what its pose
/// was meant to be carried by. Objects without a place stay where they were.
MendedScene mend_scene(Scene& scene, const MendOptions& options);

}  // namespace trivet
