// Bending of meshes: the shape operator of each face by the angles at its edges [Grinspun 2006],
// less that of the rest shape. Quadratic hinges, the alternative, know flat rest shapes alone, and
// are three times too stiff for meshes of right angles that bend along their sides.
#pragma once

#include "core/flex/total.h"

namespace trivet::flex {

/// Hinges at the inner edges of a mesh, and the faces that they bend. @param x  its rest shape.
void add_hinges(Body& body, const Points& x);

/// Energy of bending, J; adds to the derivatives that are asked for. The positive second derivative
/// leaves out how the angles themselves bend.
double bend_hinges(const Body& body, const Points& x, const Total& total);

}  // namespace trivet::flex
