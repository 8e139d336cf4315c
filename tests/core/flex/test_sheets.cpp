// Sheets with known answers, each step judged exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "core/exact/predicates.h"
#include "core/flex/elasticity.h"
#include "core/flex/self_crossings.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

bool crosses(const Points& x, const std::vector<std::array<int, 3>>& faces,
             const Obstacles& obstacles) {
  for (const auto& f : faces) {
    const Triangle triangle{x[f[0]], x[f[1]], x[f[2]]};
    Aabb box;
    for (const Vec3& corner : triangle) box.extend(corner);
    bool found = false;
    obstacles.face_tree().visit(box, [&](int other) {
      const auto& g = obstacles.faces()[other];
      const Points& y = obstacles.vertices();
      found |= triangles_intersect(triangle, {y[g[0]], y[g[1]], y[g[2]]});
    });
    if (found) return true;
  }
  return false;
}

// Runs a problem of one level and judges each of its steps.
DrapeResult judged(const DrapeProblem& problem, const Obstacles& obstacles, DrapeOptions options) {
  options.levels = 1;
  const auto faces = body_of(problem).faces;
  int num_crossing = 0;
  const DrapeResult result = drape(problem, obstacles, options, [&](const Progress& now) {
    num_crossing += self_crossing(*now.x, faces).has_value();
    num_crossing += crosses(*now.x, faces, obstacles);
    return true;
  });
  EXPECT_EQ(num_crossing, 0);
  EXPECT_FALSE(self_crossing(rounded_to_float32(result.x), faces));
  return result;
}

TEST(FlexSheets, ComeToRestOverABox) {
  Obstacles room;
  add_box(room, {-3, -3, -0.05}, {3, 3, 0});
  add_box(room, {-0.15, -0.15, 0.3}, {0.15, 0.15, 0.6});
  room.build();
  DrapeOptions options;
  options.layer = 2e-3;
  const DrapeResult result = judged(sheet(12, 12, 0.6, 0.6, {0, 0, 0.605}), room, options);
  ASSERT_EQ(result.ending, Ending::AtRest);
  EXPECT_LT(result.certificate.net_force, 1e-3);
  EXPECT_NEAR(result.certificate.balance, 1, 1e-4);
  EXPECT_NEAR(result.shares[1], 1, 1e-4);
  EXPECT_LE(result.certificate.friction_used, 1 + 1e-12);
  EXPECT_LT(result.certificate.stretch, 1.02);
  EXPECT_TRUE(result.certificate.stable);
}

TEST(FlexSheets, AreAsSymmetricAsSpheresAndSquares) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= 16; ++i)
    profile.emplace_back(i % 16 == 0 ? 0 : 0.15 * std::sin(M_PI * i / 16),
                         -0.15 * std::cos(M_PI * i / 16));
  Obstacles ball;
  add_lathe(ball, profile, 32, {0, 0, 0.5});
  ball.build();
  FlexMaterial stiff;
  stiff.bending = 2e-2;
  stiff.friction = 0;
  const DrapeProblem problem = sheet(12, 12, 0.5, 0.5, {0, 0, 0.655}, stiff);
  DrapeOptions options;
  options.minimiser.tolerance = 1e-7;
  const DrapeResult result = judged(problem, ball, options);
  ASSERT_EQ(result.ending, Ending::AtRest);
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 12; ++i) {
      const Vec3 &here = result.x[problem.grid->vertex(i, j)],
                 &mirrored = result.x[problem.grid->vertex(12 - i, j)],
                 &swapped = result.x[problem.grid->vertex(j, i)];
      EXPECT_NEAR(here.z(), mirrored.z(), 1e-6);
      EXPECT_NEAR(here.x(), -mirrored.x(), 1e-6);
      EXPECT_NEAR(here.z(), swapped.z(), 1e-6);
    }
}

// A strip clamped along one edge of its grid.
double strip_chord(bool along_u) {
  FlexMaterial m;
  m.twist = 1, m.coupling = 0;
  m.thickness = 1e-6;  // its cells are shorter than cotton is thick
  const double length = 2 * std::cbrt(m.bending / (m.density * kGravity));
  const int n = 48;
  const double l = length / n;
  DrapeProblem problem = along_u ? sheet(n + 1, 3, length + l, 3 * l, Vec3::Zero(), m)
                                 : sheet(3, n + 1, 3 * l, length + l, Vec3::Zero(), m);
  const Vec3 shift(along_u ? length / 2 - l / 2 : 0, along_u ? 0 : length / 2 - l / 2, 1);
  for (Vec3& p : problem.start) p += shift;
  const int axis = along_u ? 0 : 1;
  for (size_t v = 0; v < problem.start.size(); ++v)
    problem.pinned[v] = problem.start[v][axis] < 1e-9;
  DrapeOptions options;
  options.levels = 1;
  options.layer = 1e-6;
  const DrapeResult result = drape(problem, built({}), options);
  EXPECT_EQ(result.ending, Ending::AtRest);
  const Vec3 end = result.x.back();
  return std::atan2(1 - end.z(), end[axis]) * 180 / M_PI;
}

TEST(FlexSheets, SagAsPeirceSaysAlongWarpAndWeft) {
  const double warp = strip_chord(true), weft = strip_chord(false);
  EXPECT_NEAR(warp, 42.65, 0.1);
  EXPECT_NEAR(weft, 42.65, 0.1);
}

// A strip of these cells hangs from its upper edge. @return by how much it is longer, metres.
double hanging_stretch(int cells, const FlexMaterial& m, double length) {
  DrapeProblem problem = sheet(cells / 4, cells, length / 4, length, Vec3::Zero(), m);
  for (Vec3& p : problem.start) p = Vec3(p.x(), 0, 1 - (p.y() + length / 2));
  for (size_t v = 0; v < problem.start.size(); ++v)
    problem.pinned[v] = problem.start[v].z() > 1 - 1e-9;
  DrapeOptions options;
  options.levels = 1;
  options.layer = 1e-5;
  options.minimiser.tolerance = 1e-6;
  const DrapeResult result = drape(problem, built({}), options);
  EXPECT_EQ(result.ending, Ending::AtRest);
  EXPECT_NEAR(result.pin_share, 1, 1e-6);
  double low = 1;
  for (const Vec3& p : result.x) low = std::min(low, p.z());
  return 1 - low - length;
}

// k (r^2 - 1) / 2 r = weight below, by St. Venant-Kirchhoff, where r is the ratio of lengths.
TEST(FlexSheets, HangingClothIsStretchedByItsWeight) {
  FlexMaterial m;
  m.coupling = m.bending = m.friction = 0;
  m.thickness = 1e-5;
  m.stretch = 10;
  const double length = 0.5;
  const int n = 10000;
  double exact = 0;
  for (int i = 0; i < n; ++i) {
    const double load = m.density * kGravity * length * (1 - (i + 0.5) / n) / m.stretch;
    double r = 1;
    for (int k = 0; k < 20; ++k) r -= ((r * r - 1) * r / 2 - load) / ((3 * r * r - 1) / 2);
    exact += (r - 1) * length / n;
  }
  EXPECT_NEAR(exact, 0.017208, 1e-6);
  EXPECT_NEAR(hanging_stretch(8, m, length), exact, 6e-6);
  EXPECT_NEAR(hanging_stretch(16, m, length), exact, 2e-6);
}

// A sheet on a slope, whose steepness is `share` of its friction.
DrapeResult on_slope(double share, int max_steps) {
  FlexMaterial m;
  m.friction = 0.4;
  const double steepness = share * m.friction, run = 1 / std::sqrt(1 + steepness * steepness);
  const Vec3 down(run, 0, -steepness * run), normal(steepness * run, 0, run);
  Obstacles slope;
  Points corners;
  for (const double u : {-2.0, 2.0})
    for (const double v : {-2.0, 2.0}) corners.push_back(u * down + Vec3(0, v, 0));
  const std::vector<std::array<Index, 3>> faces{{0, 2, 1}, {2, 3, 1}};
  slope.add(corners, faces, 10);
  slope.build();
  DrapeProblem problem = sheet(6, 6, 0.3, 0.3, Vec3::Zero(), m);
  for (Vec3& p : problem.start) p = p.x() * down + Vec3(0, p.y(), 0) + 0.0006 * normal;
  DrapeOptions options;
  options.minimiser.max_steps = max_steps;
  return drape(problem, slope, options);
}

TEST(FlexSheets, RestOnSlopesUpToTheirFriction) {
  const DrapeResult held = on_slope(0.95, 400);
  EXPECT_EQ(held.ending, Ending::AtRest);
  EXPECT_GT(held.certificate.friction_used, 0.94);
  const DrapeResult slides = on_slope(1.05, 400);
  EXPECT_NE(slides.ending, Ending::AtRest);
}

// While friction is fixed, no step raises the energy; without friction, none at all.
TEST(FlexSheets, NeverGainEnergy) {
  Obstacles room;
  add_box(room, {-0.1, -0.1, 0.3}, {0.1, 0.1, 0.6});
  room.build();
  FlexMaterial smooth;
  smooth.friction = 0;
  DrapeOptions options;
  options.levels = 1;
  options.minimiser.max_steps = 300;
  double before = kInfinity;
  int steps = 0;
  drape(sheet(10, 10, 0.5, 0.5, {0.01, 0.02, 0.605}, smooth), room, options,
        [&](const Progress& now) {
          EXPECT_LE(now.energy, before + 1e-9 * std::abs(before == kInfinity ? 0 : before));
          before = now.energy;
          ++steps;
          return true;
        });
  EXPECT_GT(steps, 20);
}

TEST(FlexSheets, StopWhenToldTo) {
  int steps = 0;
  const DrapeResult result = drape(sheet(8, 8, 0.5, 0.5, {0, 0, 1}), built({}), {},
                                   [&](const Progress&) { return ++steps < 3; });
  EXPECT_EQ(result.ending, Ending::Stopped);
  EXPECT_EQ(steps, 3);
}

TEST(FlexSheets, StartsAreJudged) {
  Obstacles room;
  add_box(room, {-1, -1, 0}, {1, 1, 1});
  room.build();
  EXPECT_FALSE(start_contact(sheet(4, 4, 0.5, 0.5, {0, 0, 1.001}), room));
  const auto inside = start_contact(sheet(4, 4, 0.5, 0.5, {0, 0, 1.0002}), room);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->owner, 0);
  const auto through = start_contact(sheet(4, 4, 3, 3, {0, 0, 0.5}), room);
  ASSERT_TRUE(through);
  DrapeProblem folded = sheet(4, 4, 0.5, 0.5, {0, 0, 1.1});
  folded.start[0] = folded.start[12];
  EXPECT_TRUE(start_contact(folded, room));
}

}  // namespace
}  // namespace trivet::test
