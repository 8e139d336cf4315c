// Balance of a large part block by block, from top to bottom. Private.
#pragma once

#include <vector>

#include "ops/stability/contact_forces.h"

namespace trivet {

struct BlockBalance {
  enum class Verdict {
    Stands,   // forces balance every body
    Topples,  // `moves` do not stand even while all others stand still
    Open,     // neither was found
  };
  Verdict verdict = Verdict::Open;
  std::vector<Index> moves;  // bodies
};

/// The verdict of contact_forces() on the whole part, or none. One body after the other, from the
/// highest down, is balanced by what is below with small pushes, which load these; a body that this
/// does not balance is joined with all that touch it, and the block is balanced together. Blocks
/// are much smaller than the part, and many of them come again at the next operation.
///   Stands: the forces of the blocks together keep the limits of the whole, which is asked.
///   Topples: a block asks for less than the whole, as its neighbours stand still and it carries
///   what it carries in the whole; if it does not balance, the whole does not.
/// @param clearance  metres.
BlockBalance balance_by_blocks(const FreeBodies& part, double clearance);

}  // namespace trivet
