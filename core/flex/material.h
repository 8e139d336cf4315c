// Materials of cloth, paper and cables.
#pragma once

#include <string>

namespace trivet::flex {

/// Values are of a sheet per width, of a cable as a whole. SI units.
struct FlexMaterial {
  std::string name;         // of a preset; empty: none
  double density = 0.15;    // kg/m2; cable: kg/m
  double thickness = 5e-4;  // m; cable: its diameter
  double stretch = 1000;    // N/m of strain along warp and weft; cable: N, EA
  double coupling = 200;    // N/m: the Poisson term of both
  double shear = 50;        // N/m
  double bending = 1e-5;    // N m along warp and weft; cable: N m2, EI
  double twist = 0.8;       // share of `bending` that resists twisting: 1 - Poisson's ratio
  double friction = 0.4;    // Coulomb's coefficient, against itself, too
};

}  // namespace trivet::flex
