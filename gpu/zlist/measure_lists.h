// Private to gpu: what lists cost here.
#pragma once

#include "gpu/zlist/device.h"
#include "gpu/zlist/list_costs.h"

namespace trivet {

/// Measured with a fall, or a turn, of spheres of 1,000 and of 15,000 faces and of flat squares
/// that meet all over, from the times of whole queries with lists of either kind and without lists.
/// Takes some tens of queries. @throws Error as ZListDevice::find_candidates().
ListCosts measure_list_costs(ZListDevice& device, Motion::Kind kind);

/// Constants, as measured with llvmpipe.
ListCosts list_costs_of_llvmpipe(Motion::Kind kind);

}  // namespace trivet
