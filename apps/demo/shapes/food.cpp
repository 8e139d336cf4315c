// Apple, banana, egg, toast and loaf.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"

namespace trivet::shapes {
namespace {

Material crust() { return make_material("crust", 0.40f, 0.17f, 0.045f, 0.7f); }
Material crumb() { return make_material("crumb", 0.92f, 0.78f, 0.52f, 0.8f); }

// The outline of a slice of bread in the (y, z) plane, its flat base at z = 0: half of it, from the
// base to the top of the dome, mirrored to a closed polygon.
std::vector<Vec2> bread_outline(double half_width, double height, double tolerance) {
  const double w = half_width, h = height;
  const auto half = flatten(
      {corner({0, 0}), corner({0.86 * w, 0}), smooth({0.95 * w, 0.06 * h}),
       smooth({0.95 * w, 0.40 * h}), smooth({0.92 * w, 0.58 * h}), smooth({1.00 * w, 0.72 * h}),
       smooth({0.88 * w, 0.88 * h}), smooth({0.50 * w, 0.97 * h}), pole(h)},
      tolerance);
  std::vector<Vec2> outline;
  for (size_t i = 1; i + 1 < half.size(); ++i) outline.push_back(half[i].value.head<2>());
  outline.push_back(half.back().value.head<2>());
  for (size_t i = half.size() - 2; i >= 1; --i) outline.emplace_back(-half[i][0], half[i][1]);
  return outline;
}

}  // namespace

Model make_apple() {
  constexpr Index kRed = 0, kGreen = 1, kStem = 2;
  const auto profile =
      flatten({pole(0.0060, kGreen), smooth({0.0060, 0.0040}, kGreen), corner({0.0130, 0}, kRed),
               smooth({0.0210, 0.0030}, kRed), smooth({0.0318, 0.0170}, kRed),
               smooth({0.0375, 0.0370}, kRed), smooth({0.0350, 0.0560}, kRed),
               smooth({0.0240, 0.0685}, kRed), smooth({0.0130, 0.0690}, kGreen),
               smooth({0.0055, 0.0640}, kGreen), pole(0.0580, kGreen)},
              0.0006);
  std::vector<Ring> rings = revolve(profile, {26, 18, 0.0145});
  // Five soft ribs, and a little fuller on one side, as apples are; the base ring stays in place.
  deform(&rings, [](const Vec3& p) -> Vec3 {
    const double angle = std::atan2(p.y(), p.x()), share = p.z() / 0.069;
    const double swell = 1 + 0.025 * share * std::cos(5 * angle) + 0.03 * share * std::cos(angle);
    return {p.x() * swell, p.y() * swell, p.z() * (1 + 0.02 * std::sin(angle + 1))};
  });
  const auto stem = flatten({smooth({0.0002, 0.0585, 0.0016, 0.0016}, kStem),
                             smooth({0.0010, 0.0690, 0.0011, 0.0011}, kStem),
                             smooth({0.0050, 0.0810, 0.0015, 0.0015}, kStem)},
                            0.0006);
  return assemble("apple", {{skin(rings), 60}, {skin(sweep(stem, 6)), 60}},
                  {make_material("apple red", 0.52f, 0.035f, 0.025f, 0.3f),
                   make_material("apple green", 0.50f, 0.42f, 0.06f, 0.35f),
                   make_material("stem", 0.10f, 0.055f, 0.02f, 0.8f)});
}

Model make_banana() {
  constexpr Index kYellow = 0, kGreen = 1, kBrown = 2;
  const auto path = flatten({smooth({-0.0880, 0.0385, 0.0042, 0.0042}, kBrown),
                             smooth({-0.0850, 0.0360, 0.0044, 0.0044}, kGreen),
                             smooth({-0.0740, 0.0270, 0.0058, 0.0058}, kGreen),
                             smooth({-0.0640, 0.0190, 0.0105, 0.0105}, kYellow),
                             smooth({-0.0400, 0.0060, 0.0165, 0.0165}, kYellow),
                             smooth({-0.0050, -0.0020, 0.0182, 0.0182}, kYellow),
                             smooth({0.0330, 0.0030, 0.0172, 0.0172}, kYellow),
                             smooth({0.0620, 0.0180, 0.0125, 0.0125}, kYellow),
                             smooth({0.0770, 0.0310, 0.0065, 0.0065}, kGreen),
                             smooth({0.0830, 0.0375, 0.0036, 0.0036}, kBrown),
                             smooth({0.0850, 0.0400, 0.0028, 0.0028}, kBrown)},
                            0.0008);
  std::vector<Ring> rings = sweep(path, 15);
  // From a round section to one with five soft edges; then from the xz plane onto its side.
  for (size_t i = 0; i < rings.size(); ++i) {
    const Vec3 centre(path[i][0], 0, path[i][1]);
    for (size_t k = 0; k < rings[i].points.size(); ++k) {
      Vec3& p = rings[i].points[k];
      p = centre + (1 + 0.06 * std::cos(kTurn * static_cast<double>(k) / 3)) * (p - centre);
      p = Vec3(p.x(), p.z(), -p.y());
    }
  }
  return assemble("banana", {{skin(rings), 60}},
                  {make_material("banana", 0.85f, 0.58f, 0.05f, 0.5f),
                   make_material("banana green", 0.52f, 0.50f, 0.07f, 0.5f),
                   make_material("banana tip", 0.06f, 0.04f, 0.02f, 0.8f)});
}

Model make_egg() {
  const auto profile = flatten(
      {pole(0), smooth({0.0120, 0.0034}), smooth({0.0198, 0.0140}), smooth({0.0218, 0.0250}),
       smooth({0.0190, 0.0400}), smooth({0.0110, 0.0525}), pole(0.0580)},
      0.0005);
  const Part shell{skin(revolve(profile, {24, 12, 0.0105})), 60};
  return assemble("egg", {shell}, {make_material("egg shell", 0.72f, 0.46f, 0.30f, 0.5f)});
}

Model make_toast() {
  constexpr Index kCrust = 0, kBrowned = 1, kCrumb = 2;
  const double thickness = 0.013;
  const auto outline = bread_outline(0.050, 0.098, 0.0007);
  const auto ring = [&](double scale, double z, Index material) {
    Ring out{{}, material};
    for (const Vec2& p : outline)
      out.points.emplace_back(scale * p.x(), scale * (p.y() - 0.049), z);
    return out;
  };
  const std::vector<Ring> rings{
      ring(0.72, 0, kBrowned),         ring(0.96, 0, kCrust),
      ring(1.00, 0.002, kCrust),       ring(1.00, thickness - 0.002, kCrust),
      ring(0.96, thickness, kBrowned), ring(0.72, thickness, kCrumb)};
  return assemble("toast", {{skin(rings), 40}},
                  {crust(), make_material("toasted", 0.56f, 0.29f, 0.09f, 0.8f),
                   make_material("toasted middle", 0.68f, 0.40f, 0.15f, 0.8f)});
}

Model make_loaf() {
  constexpr Index kCrust = 0, kCrumb = 1;
  const auto outline = bread_outline(0.055, 0.1, 0.0009);
  std::vector<Ring> rings;
  // x, scale of the width and of the height: round at the far end, cut straight at the near one.
  const auto line = flatten(
      {smooth({-0.1100, 0.60, 0.40}), smooth({-0.1060, 0.78, 0.62}), smooth({-0.0930, 0.93, 0.86}),
       smooth({-0.0600, 1.00, 1.00}), smooth({0.0000, 1.02, 1.03}), smooth({0.0600, 1.00, 1.00}),
       corner({0.0950, 0.98, 0.96}, kCrumb)},
      0.006);
  for (const CurveSample& at : line) {
    Ring ring{{}, at.material};
    for (const Vec2& p : outline) ring.points.emplace_back(at[0], at[1] * p.x(), at[2] * p.y());
    rings.push_back(std::move(ring));
  }
  Ring inner{{}, kCrumb};
  for (const Vec3& p : rings.back().points)
    inner.points.emplace_back(p.x(), 0.93 * p.y(), 0.04 * 0.1 + 0.92 * p.z());
  rings.back().material = kCrust;
  rings.push_back(std::move(inner));
  return assemble("loaf", {{skin(rings), 55}}, {crust(), crumb()});
}

}  // namespace trivet::shapes
