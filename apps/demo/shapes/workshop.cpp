// A workbench, tools, and small parts with the bin they lie in. Fronts are at -y.
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

Part plain_box(const Vec3& lower, const Vec3& upper, Index material = 0) {
  return {painted(box(lower, upper), material), 40};
}

Material steel() { return make_material("steel", 0.42f, 0.43f, 0.45f, 0.35f, 0.6f); }
Material beech() { return make_material("beech", 0.58f, 0.38f, 0.20f, 0.55f); }
Material red_paint() { return make_material("red paint", 0.55f, 0.05f, 0.03f, 0.35f); }

// A surface of revolution about z that is laid along x.
Surface lying(const std::vector<CurveSample>& profile, int segments) {
  return turned(skin(revolve(profile, {segments, segments, 0})), Vec3::UnitY(), 90);
}

}  // namespace

Model make_workbench() {
  constexpr Index kTop = 0, kFrame = 1;
  const double half_x = 0.75, half_y = 0.32, under = kBenchHeight - 0.045, in = 0.001;
  std::vector<Part> parts;
  parts.push_back(plain_box({-half_x, -half_y, under}, {half_x, half_y, kBenchHeight}, kTop));
  for (const double x : {-0.68, 0.62})
    for (const double y : {-0.28, 0.22})
      parts.push_back(plain_box({x, y, 0}, {x + 0.06, y + 0.06, under + in}, kFrame));
  parts.push_back(plain_box({-0.66, -0.26, 0.20}, {0.66, 0.26, 0.22}, kTop));
  return assemble("workbench", parts,
                  {beech(), make_material("bench frame", 0.20f, 0.26f, 0.30f, 0.5f)});
}

Model make_parts_bin() {
  const double x = 0.15, y = 0.11, wall = 0.004, high = 0.09, in = 0.0005;
  std::vector<Part> parts;
  parts.push_back(plain_box({-x, -y, 0}, {x, y, wall}));
  for (const double s : {-1.0, 1.0}) {
    const double a = s * x, b = s * (x - wall), c = s * y, d = s * (y - wall);
    parts.push_back(plain_box({std::min(a, b), -y, wall - in}, {std::max(a, b), y, high}));
    parts.push_back(plain_box({-x + wall - in, std::min(c, d), wall - in},
                              {x - wall + in, std::max(c, d), high}));
  }
  return assemble("parts_bin", parts, {make_material("bin", 0.08f, 0.22f, 0.50f, 0.5f)});
}

Model make_bolt() {
  const auto head = flatten(
      {corner({0, 0}), corner({0.0095, 0}), corner({0.0095, 0.0060}), corner({0, 0.0060})}, 0.0001);
  const auto shank =
      flatten({corner({0, 0.0055}), corner({0.0050, 0.0055}), corner({0.0050, 0.0440}),
               corner({0.0042, 0.0450}), corner({0, 0.0450})},
              0.0001);
  const Surface hexagon = turned(lying(head, 6), Vec3::UnitX(), 30);
  return assemble("bolt", {{hexagon, 30}, {lying(shank, 12), 40}}, {steel()});
}

// Its thread is a hole that ends near its underside.
Model make_nut() {
  const auto profile =
      flatten({corner({0, 0}), corner({0.0095, 0}), corner({0.0095, 0.0080}),
               corner({0.0050, 0.0080}), corner({0.0050, 0.0010}), corner({0, 0.0010})},
              0.0001);
  return assemble("nut", {{skin(revolve(profile, {6, 6, 0})), 30}}, {steel()});
}

Model make_bracket() {
  return assemble("bracket",
                  {plain_box({-0.02, -0.0125, 0}, {0.02, 0.0125, 0.003}),
                   plain_box({-0.02, -0.0125, 0.0025}, {-0.017, 0.0125, 0.035})},
                  {silver()});
}

Model make_hammer() {
  constexpr Index kHead = 0, kHandle = 1;
  return assemble(
      "hammer",
      {plain_box({-0.016, -0.055, 0}, {0.016, 0.055, 0.028}, kHead),
       {painted(box({0.0155, -0.013, 0.004}, {0.270, 0.013, 0.024}, 0.004), kHandle), 40}},
      {steel(), beech()});
}

Model make_screwdriver() {
  constexpr Index kGrip = 0, kBlade = 1;
  const auto profile = flatten({corner({0, -0.100}, kGrip), corner({0.0120, -0.098}, kGrip),
                                smooth({0.0150, -0.060}, kGrip), smooth({0.0120, -0.020}, kGrip),
                                corner({0.0090, 0}, kBlade), corner({0.0035, 0.002}, kBlade),
                                corner({0.0035, 0.100}, kBlade), corner({0, 0.102}, kBlade)},
                               0.0005);
  return assemble("screwdriver", {{lying(profile, 10), 40}}, {red_paint(), silver()});
}

Model make_toolbox() {
  constexpr Index kPaint = 0, kMetal = 1;
  std::vector<Part> parts{plain_box({-0.20, -0.09, 0}, {0.20, 0.09, 0.16}, kPaint)};
  for (const double x : {-0.08, 0.07})
    parts.push_back(plain_box({x, -0.008, 0.159}, {x + 0.01, 0.008, 0.200}, kMetal));
  parts.push_back(plain_box({-0.08, -0.010, 0.199}, {0.08, 0.010, 0.215}, kMetal));
  return assemble("toolbox", parts, {red_paint(), steel()});
}

}  // namespace trivet::shapes
