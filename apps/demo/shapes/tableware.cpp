// Saucer, plate, bowl, egg cup, glass and cup: surfaces of revolution. Profiles run from the axis
// below, up the outside, over the rim and back to the axis inside: (radius, height).
#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/palette.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {

namespace {

constexpr Index kGlaze = 0, kBand = 1, kDrink = 2;
constexpr double kSink = 0.0006;  // how deep handles go into the wall, which is 2 mm thick

}  // namespace

Model make_saucer() {
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0330, 0}), corner({0.0345, 0.0020}), smooth({0.054, 0.0078}),
       smooth({0.0728, 0.0182}), smooth({0.0750, 0.0205}, kBand), smooth({0.0735, 0.0212}, kBand),
       smooth({0.0705, 0.0196}), smooth({0.053, 0.0108}), smooth({0.0350, 0.0074}),
       corner({0.0325, 0.0070}), corner({0.0310, 0.0045}), corner({0, 0.0045})},
      0.0008);
  const Part body{skin(revolve(profile, {38, 24, 0.0352}))};
  return assemble("saucer", {body}, {porcelain(), cobalt()});
}

Model make_plate() {
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0690, 0}), corner({0.0715, 0.0020}), smooth({0.0830, 0.0080}),
       smooth({0.1, 0.0130}), smooth({0.1185, 0.0197}, kBand), smooth({0.1200, 0.0217}, kBand),
       smooth({0.1180, 0.0228}, kBand), smooth({0.1135, 0.0212}), smooth({0.1015, 0.0173}, kBand),
       smooth({0.0990, 0.0166}), smooth({0.0890, 0.0143}), smooth({0.0800, 0.0090}),
       corner({0.0720, 0.0055}), corner({0, 0.0055})},
      0.0011);
  const Part body{skin(revolve(profile, {40, 28, 0.073}))};
  return assemble("plate", {body}, {porcelain(), cobalt()});
}

Model make_bowl() {
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0600, 0}), corner({0.0620, 0.0045}), smooth({0.083, 0.012}),
       smooth({0.106, 0.038}, kBand), smooth({0.1125, 0.051}), smooth({0.125, 0.0795}),
       smooth({0.1275, 0.0835}, kBand), smooth({0.1255, 0.0855}, kBand), smooth({0.1220, 0.0825}),
       smooth({0.1075, 0.050}), smooth({0.0960, 0.030}), smooth({0.0820, 0.0125}),
       corner({0.072, 0.0090}), corner({0, 0.0090})},
      0.0010);
  const Part body{skin(revolve(profile, {40, 28, 0.073}))};
  return assemble("bowl", {body}, {stoneware(), stoneware_rim()});
}

Model make_egg_cup() {
  // The rim is narrower than the egg, which so rests on it well below its middle.
  const auto profile =
      flatten({corner({0, 0}), corner({0.0225, 0}), smooth({0.0235, 0.0025}, kBand),
               smooth({0.0215, 0.0055}), smooth({0.0105, 0.0120}), smooth({0.0085, 0.0170}),
               smooth({0.0115, 0.0220}), smooth({0.0182, 0.0310}), smooth({0.0206, 0.0440}, kBand),
               smooth({0.0200, 0.0460}, kBand), smooth({0.0182, 0.0455}), smooth({0.0165, 0.0370}),
               smooth({0.0110, 0.0290}), pole(0.0265)},
              0.0006);
  const Part body{skin(revolve(profile, {24, 16, 0.0120}))};
  return assemble("egg_cup", {body}, {porcelain(), cobalt()});
}

Model make_glass() {
  // The juice is part of the surface, and lets no light through.
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0265, 0}), smooth({0.0290, 0.0030}),
       smooth({0.0297, 0.0120}, kDrink), smooth({0.0322, 0.0480}, kDrink), smooth({0.0352, 0.0840}),
       smooth({0.0374, 0.1090}), smooth({0.0373, 0.1118}), smooth({0.0358, 0.1116}),
       smooth({0.0350, 0.1060}), corner({0.0333, 0.0840}, kDrink), corner({0, 0.0840})},
      0.0004);
  const Part body{skin(revolve(profile, {32, 32, 0}))};
  return assemble("glass", {body}, {clear_glass(), clear_glass(), orange_juice()});
}

Model make_cup() {
  const auto profile = flatten(
      {corner({0, 0}), corner({0.0235, 0}), corner({0.0240, 0.0040}), smooth({0.0310, 0.0130}),
       smooth({0.0362, 0.0290}), smooth({0.0386, 0.0450}), smooth({0.0408, 0.0605}, kBand),
       smooth({0.0414, 0.0640}, kBand), smooth({0.0404, 0.0650}, kBand), smooth({0.0392, 0.0625}),
       smooth({0.0375, 0.0530}), corner({0.0365, 0.0470}, kDrink), corner({0, 0.0470})},
      0.0004);
  const Part body{skin(revolve(profile, {36, 24, 0.0250}))};
  // An ear.
  const auto ear =
      flatten({smooth({0.0385, 0.0515, 0.0034, 0.0052}), smooth({0.0460, 0.0540, 0.0026, 0.0042}),
               smooth({0.0585, 0.0520, 0.0024, 0.0044}), smooth({0.0640, 0.0420, 0.0024, 0.0044}),
               smooth({0.0570, 0.0290, 0.0024, 0.0042}), smooth({0.0440, 0.0215, 0.0026, 0.0042}),
               smooth({0.0330, 0.0185, 0.0032, 0.0050})},
              0.0007);
  return assemble("cup", {body, handle(ear, 10, profile, kSink)}, {porcelain(), cobalt(), tea()});
}

}  // namespace trivet::shapes
