// Mug, pencil, pen, waste basket and plant.
#include <cmath>

#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {

Model make_mug() {
  constexpr Index kGlaze = 0, kBand = 1;
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0340, 0}), smooth({0.0385, 0.0030}), smooth({0.0400, 0.0120}),
       corner({0.0405, 0.0200}, kBand), corner({0.0410, 0.0320}, kGlaze), smooth({0.0415, 0.0930}),
       smooth({0.0402, 0.0960}), smooth({0.0385, 0.0940}), smooth({0.0370, 0.0120}),
       smooth({0.0340, 0.0065}), corner({0, 0.0060})},
      0.0004);
  const Part body{skin(revolve(profile, {36, 36, 0}))};
  const auto ear =
      flatten({smooth({0.0410, 0.0800, 0.0046, 0.0070}), smooth({0.0520, 0.0825, 0.0038, 0.0060}),
               smooth({0.0670, 0.0740, 0.0036, 0.0060}), smooth({0.0700, 0.0530, 0.0036, 0.0060}),
               smooth({0.0640, 0.0340, 0.0036, 0.0060}), smooth({0.0520, 0.0255, 0.0038, 0.0060}),
               smooth({0.0405, 0.0270, 0.0046, 0.0070})},
              0.0007);
  return assemble("mug", {body, handle(ear, 10, profile, 0.0010)},
                  {make_material("mug", 0.70f, 0.16f, 0.07f, 0.2f), porcelain()});
}

Model make_pencil() {
  constexpr Index kRubber = 0, kFerrule = 1, kPaint = 2, kWood = 3, kLead = 4;
  const auto profile =
      flatten({corner({0, -0.0870}, kRubber), corner({0.0030, -0.0870}, kRubber),
               corner({0.0034, -0.0790}, kFerrule), corner({0.0036, -0.0790}, kFerrule),
               corner({0.0036, -0.0670}, kFerrule), corner({0.0040, -0.0670}, kPaint),
               corner({0.0040, 0.0680}, kWood), corner({0.0011, 0.0830}, kLead),
               corner({0, 0.0880}, kLead)},
              0.0001);
  // It lies on a side of its hexagon, its tip at +x.
  const Surface upright = turned(skin(revolve(profile, {6, 6, 0})), Vec3::UnitZ(), 30);
  return assemble("pencil", {{turned(upright, Vec3::UnitY(), 90), 30}},
                  {make_material("rubber", 0.70f, 0.30f, 0.30f, 0.8f), silver(),
                   make_material("pencil paint", 0.85f, 0.42f, 0.02f, 0.35f),
                   make_material("cut wood", 0.72f, 0.48f, 0.26f, 0.7f),
                   make_material("lead", 0.05f, 0.05f, 0.055f, 0.5f)});
}

Model make_pen() {
  constexpr Index kBarrel = 0, kMetal = 1;
  const auto profile = flatten(
      {pole(-0.0700, kMetal), smooth({0.0020, -0.0690}, kMetal), corner({0.0022, -0.0640}, kMetal),
       corner({0.0048, -0.0630}, kBarrel), smooth({0.0054, -0.0500}, kBarrel),
       smooth({0.0054, 0.0400}, kBarrel), corner({0.0046, 0.0520}, kMetal),
       corner({0.0012, 0.0660}, kMetal), corner({0, 0.0690}, kMetal)},
      0.0002);
  const Surface clip =
      painted(box({-0.0066, -0.0014, -0.0600}, {-0.0047, 0.0014, -0.0560}), kMetal);
  const Surface blade =
      painted(box({-0.0068, -0.0013, -0.0600}, {-0.0058, 0.0013, -0.0220}), kMetal);
  std::vector<Part> parts{{skin(revolve(profile, {16, 16, 0})), 40}, {clip, 40}, {blade, 40}};
  for (Part& part : parts) part.surface = turned(part.surface, Vec3::UnitY(), 90);
  return assemble("pen", parts, {make_material("barrel", 0.02f, 0.04f, 0.20f, 0.25f), silver()});
}

Model make_waste_basket() {
  const auto profile =
      flatten({corner({0, 0}), corner({0.1050, 0}), smooth({0.1090, 0.0030}),
               corner({0.1110, 0.0120}), corner({0.1390, 0.2360}), smooth({0.1440, 0.2400}),
               smooth({0.1450, 0.2460}), smooth({0.1400, 0.2500}), corner({0.1360, 0.2460}),
               corner({0.1075, 0.0100}), corner({0.1000, 0.0050}), corner({0, 0.0050})},
              0.0008);
  // The wall is ribbed, inside and outside alike.
  auto rings = revolve(profile, {48, 48, 0});
  deform(&rings, [](const Vec3& p) -> Vec3 {
    const bool wall = p.z() > 0.008 && p.z() < 0.238 && std::hypot(p.x(), p.y()) > 0.09;
    const double rib = wall ? 0.015 * std::cos(12 * std::atan2(p.y(), p.x())) : 0;
    return {p.x() * (1 + rib), p.y() * (1 + rib), p.z()};
  });
  return assemble("waste_basket", {{skin(rings), 40}},
                  {make_material("basket", 0.10f, 0.13f, 0.14f, 0.55f)});
}

namespace {

// A long leaf that rises from the earth and bends outwards: how far out its tip is, how high its
// highest point, how wide it is.
Surface leaf(double reach, double height, double width, double angle_deg) {
  const auto path = flatten({smooth({0.012, 0.098, 0.0012, 0.30 * width}),
                             smooth({0.20 * reach, 0.098 + 0.62 * height, 0.0011, 0.75 * width}),
                             smooth({0.50 * reach, 0.098 + 0.98 * height, 0.0010, width}),
                             smooth({0.82 * reach, 0.098 + 0.82 * height, 0.0009, 0.7 * width}),
                             smooth({reach, 0.098 + 0.45 * height, 0.0006, 0.06 * width})},
                            0.0022);
  return turned(skin(sweep(path, 6)), Vec3::UnitZ(), angle_deg);
}

}  // namespace

Model make_plant() {
  constexpr Index kEarth = 1, kLeaf = 2, kYoungLeaf = 3;
  const auto profile =
      flatten({corner({0, 0}), corner({0.0520, 0}), corner({0.0540, 0.0020}),
               corner({0.0680, 0.0850}), corner({0.0745, 0.0860}), corner({0.0770, 0.1100}),
               smooth({0.0755, 0.1120}), corner({0.0715, 0.1110}), corner({0.0700, 0.1010}, kEarth),
               smooth({0.04, 0.1035}, kEarth), corner({0, 0.1045}, kEarth)},
              0.0010);
  std::vector<Part> parts{{skin(revolve(profile, {36, 36, 0})), 40}};
  const double golden_deg = 137.5;  // from each leaf to the next, as leaves grow
  for (int i = 0; i < 15; ++i) {
    const double young = i / 14.0;
    const Surface grown =
        leaf(0.185 - 0.105 * young, 0.13 + 0.12 * young, 0.014 - 0.004 * young, golden_deg * i);
    parts.push_back({painted(grown, i < 9 ? kLeaf : kYoungLeaf), 60});
  }
  return assemble("plant", parts,
                  {make_material("clay", 0.50f, 0.17f, 0.08f, 0.8f),
                   make_material("earth", 0.055f, 0.032f, 0.02f, 0.95f),
                   make_material("leaf", 0.05f, 0.22f, 0.045f, 0.5f),
                   make_material("young leaf", 0.14f, 0.36f, 0.06f, 0.5f)});
}

}  // namespace trivet::shapes
