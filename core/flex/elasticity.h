// Weight, tension and bending of a flexible body.
#pragma once

#include "core/flex/total.h"

namespace trivet::flex {

/// Energy at these positions; adds to the derivatives that are asked for.
double elastic_energy(const Body& body, const Points& x, Total& total);

/// Largest ratio of lengths to those at rest: along warp and weft in a face, or along a cable.
double largest_stretch(const Body& body, const Points& x);

}  // namespace trivet::flex
