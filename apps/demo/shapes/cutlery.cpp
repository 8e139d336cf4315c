// Spoon and knife: lofts through sections across x. Section points are (y, z).
#include <cmath>
#include <numbers>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"

namespace trivet::shapes {
namespace {

// A section of the spoon: an upper and a lower face, `hollow` deep below the rim, joined by a thin
// edge. `across` points in each face.
Ring spoon_section(const CurveSample& at, int across) {
  const double rim = at[1], half_width = at[2], hollow = at[3], body = at[4], edge = 0.0008;
  Ring ring;
  for (const int face : {0, 1}) {
    for (int k = 0; k < across; ++k) {
      const double t = -1 + 2.0 * k / (across - 1), u = face == 0 ? t : -t;
      const double sag = face == 0 ? hollow : hollow + body;
      const double z = rim - sag * (1 - u * u * std::abs(u)) - (face == 0 ? 0 : edge);
      ring.points.emplace_back(at[0], half_width * u, z);
    }
  }
  return ring;
}

// A section of the knife between its back (y = at[1]) and its edge (y = at[2]), half as thick as
// at[3] there and at[4] here, rounded.
Ring knife_section(const CurveSample& at, int segments, double z_middle) {
  const double half_width = 0.5 * (at[1] - at[2]), middle = 0.5 * (at[1] + at[2]);
  const auto blunt = [](double c) { return std::copysign(std::sqrt(std::abs(c)), c); };
  Ring ring{{}, at.material};
  for (int k = 0; k < segments; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / segments;
    const double u = blunt(std::cos(angle)), v = blunt(std::sin(angle));
    const double half_thickness = 0.5 * ((1 + u) * at[3] + (1 - u) * at[4]);
    ring.points.emplace_back(at[0], middle + half_width * u, z_middle + half_thickness * v);
  }
  return ring;
}

}  // namespace

Model make_spoon() {
  // x, height of the rim, half width, hollow, thickness in the middle.
  const auto line = flatten({smooth({-0.0700, 0.0086, 0.0022, 0.0002, 0.0010}),
                             smooth({-0.0680, 0.0086, 0.0062, 0.0014, 0.0011}),
                             smooth({-0.0620, 0.0086, 0.0110, 0.0044, 0.0012}),
                             smooth({-0.0500, 0.0087, 0.0148, 0.0072, 0.0013}),
                             smooth({-0.0370, 0.0090, 0.0140, 0.0070, 0.0014}),
                             smooth({-0.0260, 0.0098, 0.0092, 0.0040, 0.0017}),
                             smooth({-0.0200, 0.0108, 0.0048, 0.0008, 0.0020}),
                             smooth({-0.0120, 0.0128, 0.0030, -0.0002, 0.0023}),
                             smooth({0.0080, 0.0172, 0.0028, -0.0004, 0.0022}),
                             smooth({0.0350, 0.0150, 0.0042, -0.0006, 0.0020}),
                             smooth({0.0560, 0.0085, 0.0064, -0.0006, 0.0019}),
                             smooth({0.0650, 0.0055, 0.0062, -0.0005, 0.0018}),
                             smooth({0.0690, 0.0046, 0.0036, -0.0003, 0.0016}),
                             smooth({0.0700, 0.0045, 0.0012, -0.0001, 0.0014})},
                            0.0006);
  std::vector<Ring> rings;
  for (const CurveSample& at : line) rings.push_back(spoon_section(at, at[0] < -0.0195 ? 6 : 3));
  return assemble("spoon", {{skin(rings), 60}}, {silver()});
}

Model make_knife() {
  constexpr Index kBlade = 0, kHandle = 1;
  // x, y of the back and of the edge, half thickness at the back and at the edge.
  const auto line = flatten({smooth({-0.1050, 0.0060, 0.0030, 0.0006, 0.0004}, kBlade),
                             smooth({-0.1030, 0.0078, -0.0020, 0.0009, 0.0003}, kBlade),
                             smooth({-0.0930, 0.0094, -0.0080, 0.0011, 0.0003}, kBlade),
                             smooth({-0.0600, 0.0092, -0.0100, 0.0013, 0.0003}, kBlade),
                             smooth({-0.0020, 0.0078, -0.0092, 0.0016, 0.0004}, kBlade),
                             corner({0.0040, 0.0062, -0.0060, 0.0020, 0.0010}, kBlade),
                             corner({0.0080, 0.0062, -0.0062, 0.0045, 0.0045}, kHandle),
                             smooth({0.0300, 0.0076, -0.0076, 0.0056, 0.0056}, kHandle),
                             smooth({0.0750, 0.0092, -0.0092, 0.0062, 0.0062}, kHandle),
                             smooth({0.0980, 0.0100, -0.0104, 0.0064, 0.0064}, kHandle),
                             smooth({0.1035, 0.0076, -0.0086, 0.0050, 0.0050}, kHandle),
                             smooth({0.1050, 0.0030, -0.0040, 0.0022, 0.0022}, kHandle)},
                            0.0008);
  std::vector<Ring> rings;
  for (const CurveSample& at : line) rings.push_back(knife_section(at, 8, 0.0064));
  return assemble("knife", {{skin(rings), 45}}, {silver(), dark_wood()});
}

}  // namespace trivet::shapes
