// Tables, with and without a cloth, and a wall with pegs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "apps/demo/shapes/parts.h"

namespace trivet::shapes {
namespace {

constexpr Index kWood = 0, kLinen = 1, kStripe = 2;
constexpr Index kPlaster = 1, kPegSteel = 2;
const Vec2 kHalfTop(0.6, 0.4);

// A leg that gets thinner downwards, 1 mm deep in the top.
Part leg(double sx, double sy) {
  const std::vector<Ring> rings{rounded_rectangle(0.016, 0.016, 0.004, 1, 0),
                                rounded_rectangle(0.028, 0.028, 0.004, 1, 0.600),
                                rounded_rectangle(0.028, 0.028, 0.004, 1, 0.711)};
  return {moved(skin(rings), {sx * 0.53, sy * 0.33, 0}), 40};
}

// A board between two legs, 1 mm deep in both and in the top.
Part apron(const Vec2& half_size, const Vec2& centre) {
  const Vec2& h = half_size;
  const std::vector<Ring> rings{rounded_rectangle(h.x(), h.y(), 0.002, 1, 0.630),
                                rounded_rectangle(h.x(), h.y(), 0.002, 1, 0.711)};
  return {moved(skin(rings), {centre.x(), centre.y(), 0}), 40};
}

// Depth of the folds of the cloth's hanging end: none on the table, more further down.
double fold(double y, double z) {
  const double down = std::clamp((0.725 - z) / 0.16, 0.0, 1.0);
  return 0.016 * down * (1 + std::cos(y * 2 * std::numbers::pi / 0.232));
}

// Strips along x across the whole table and over its ends, one ring per station of the path.
Part cloth() {
  const double low = kTableHeight - 0.0005, high = kClothHeight, thickness = high - low;
  const auto path =
      flatten({corner({0.6060, 0.560}), smooth({0.6050, 0.640}), smooth({0.6045, 0.715}),
               smooth({0.6040, 0.730}), smooth({0.6010, 0.7375}), smooth({0.5960, 0.73925}),
               corner({0.5900, low})},
              0.0012);
  std::vector<double> columns{-0.345, -0.335, -0.315};
  for (int k = 0; k <= 10; ++k) columns.push_back(-0.29 + 0.58 * k / 10);
  for (const double y : {0.315, 0.335, 0.345}) columns.push_back(y);
  std::vector<Ring> rings;
  const auto add_ring = [&](const CurveSample& at, double sign) {
    Ring ring{{}, kLinen};
    const double t = thickness, out = std::clamp((low - at[1]) / 0.01, 0.0, 1.0);
    for (const double y : columns)  // outer face
      ring.points.emplace_back(sign * (at[0] + fold(y, at[1]) + out * t), y, at[1] + (1 - out) * t);
    for (auto y = columns.rbegin(); y != columns.rend(); ++y)
      ring.points.emplace_back(sign * (at[0] + fold(*y, at[1])), *y, at[1]);
    rings.push_back(std::move(ring));
  };
  for (const CurveSample& at : path) add_ring(at, 1);
  for (auto at = path.rbegin(); at != path.rend(); ++at) add_ring(*at, -1);
  Surface surface = skin(rings);
  for (size_t f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    const double y = std::abs(t[0].y() + t[1].y() + t[2].y()) / 3;
    if (y > 0.316 && y < 0.334) surface.materials[f] = kStripe;
  }
  return {std::move(surface), 40};
}

std::vector<Part> table_without_cloth() {
  std::vector<Part> parts{{skin(slab(kHalfTop, 0.02, 0.004, 0.710, kTableHeight, 4)), 40}};
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0}) parts.push_back(leg(sx, sy));
  for (const double s : {-1.0, 1.0}) {
    parts.push_back(apron({0.503, 0.010}, {0, s * 0.34}));
    parts.push_back(apron({0.010, 0.303}, {s * 0.54, 0}));
  }
  return parts;
}

Material wood() { return make_material("wood", 0.30f, 0.145f, 0.06f, 0.5f); }

}  // namespace

Model make_bare_table() { return assemble("bare_table", table_without_cloth(), {wood()}); }

Model make_pegs() {
  std::vector<Part> parts{
      {painted(box({-0.45, 0, 0}, {0.45, 0.04, 1.75}), kPlaster), 40},
      {painted(box({-0.3, -0.018, 1.46}, {0.3, 0.001, 1.54}, 0.003), kWood), 40}};
  for (const double x : {-0.2, 0.0, 0.2})
    parts.push_back(
        {painted(rod({x, -0.017, kPegHeight}, {x, -0.085, kPegHeight + 0.015}, 0.006, 0.009, 16),
                 kPegSteel),
         40});
  return assemble("pegs", parts,
                  {wood(), make_material("plaster", 0.72f, 0.70f, 0.64f, 0.9f),
                   make_material("steel", 0.55f, 0.55f, 0.56f, 0.3f, 1.0f)});
}

Model make_table() {
  std::vector<Part> parts = table_without_cloth();
  parts.push_back(cloth());
  return assemble("table", parts,
                  {wood(), make_material("linen", 0.78f, 0.75f, 0.68f, 0.9f),
                   make_material("linen stripe", 0.10f, 0.20f, 0.38f, 0.9f)});
}

}  // namespace trivet::shapes
