#include <gtest/gtest.h>

#include "placed_meshes.h"

namespace trivet::test {
namespace {

constexpr unsigned kContainmentSeed = 20240614;

Soup cube(double half) { return box_soup(Vec3::Constant(-half), Vec3::Constant(half)); }

// Counts under several poses; both meshes in the same frame.
int inside(const Soup& inner, const Soup& outer) {
  Source source(kContainmentSeed);
  const int count = count_components_inside(Placed(inner), Placed(outer));
  for (int i = 0; i < 20; ++i) {
    const Affine pose = random_affine(source, i < 10 ? 1 : 1e5, i % 2);
    EXPECT_EQ(count_components_inside(Placed(inner, pose), Placed(outer, pose)), count);
  }
  return count;
}

// Every other face flipped: still even, no longer balanced.
Soup disordered(Soup soup) {
  for (size_t i = 0; i < soup.size(); i += 2) std::swap(soup[i][1], soup[i][2]);
  return soup;
}

struct Ball {
  Vec3 centre;
  double radius;
  int kind;  // 0 outwards, 1 inside out, 2 disordered
};

Soup soup_of(const Ball& b) {
  const Soup soup = sphere_soup(b.centre, b.radius, 1);
  return b.kind == 0 ? soup : b.kind == 1 ? reversed(soup) : disordered(soup);
}

// The mesh of level 1 lies between the sphere and this fraction of it.
constexpr double kInscribed = 0.8;

// True if the surfaces do not cross.
bool clear_of(const Ball& a, const Ball& b) {
  const double d = (a.centre - b.centre).norm();
  return d > a.radius + b.radius || d + a.radius < kInscribed * b.radius ||
         d + b.radius < kInscribed * a.radius;
}

Ball random_ball(Source& source, double max_radius) {
  return {source.point(-1, 1), source.uniform(0.02, max_radius), source.integer(0, 2)};
}

std::vector<Ball> random_balls(Source& source, int num) {
  std::vector<Ball> out;
  while (static_cast<int>(out.size()) < num) {
    const Ball ball = random_ball(source, 3);
    const auto clear = [&](const Ball& b) { return clear_of(ball, b); };
    if (std::all_of(out.begin(), out.end(), clear)) out.push_back(ball);
  }
  return out;
}

bool truth(const Ball& inner, const std::vector<Ball>& outer) {
  int winding = 0;
  bool odd = false;
  for (const Ball& b : outer) {
    if ((inner.centre - b.centre).norm() > b.radius || inner.radius > b.radius) continue;
    if (b.kind == 2)
      odd = true;
    else
      winding += b.kind == 0 ? 1 : -1;
  }
  return winding != 0 || odd;
}

}  // namespace

TEST(Containment, CountsBoxes) {
  EXPECT_EQ(inside(cube(1), cube(3)), 1);
  EXPECT_EQ(inside(cube(3), cube(1)), 0) << "the larger one";
  EXPECT_EQ(inside(cube(1), reversed(cube(3))), 1) << "inside out";
  EXPECT_EQ(inside(reversed(cube(1)), cube(3)), 1);
  EXPECT_EQ(inside(cube(1), disordered(cube(3))), 1) << "by parity";
  EXPECT_EQ(inside(cube(1), joined(cube(3), cube(4))), 1) << "winding 2";
  EXPECT_EQ(inside(cube(1), joined(disordered(cube(3)), disordered(cube(4)))), 1)
      << "parity counts for each component alone";
}

TEST(Containment, RespectsHollowShells) {
  const Soup hollow = joined(cube(3), reversed(cube(2)));
  EXPECT_EQ(inside(cube(1), hollow), 0) << "in the hollow";
  EXPECT_EQ(inside(box_soup(Vec3(2.2, 0, 0), Vec3(2.8, 1, 1)), hollow), 1) << "in the wall";
  EXPECT_EQ(inside(cube(1), joined(cube(3), cube(2))), 1) << "the inner surface is not flipped";
  EXPECT_EQ(inside(hollow, cube(4)), 2) << "both surfaces";
}

TEST(Containment, HandlesOpenMeshes) {
  Soup open = cube(3);
  open.pop_back();
  EXPECT_EQ(inside(cube(1), open), 0);
  EXPECT_EQ(inside(open, cube(4)), 1) << "an open mesh may be inside";
  EXPECT_EQ(inside(cube(1), joined(open, cube(2))), 1) << "another component is closed";
}

TEST(Containment, CountsEachComponent) {
  const auto at = [](double x) { return box_soup(Vec3(x, 0, 0), Vec3(x + 0.5, 0.5, 0.5)); };
  const Soup inner = joined(joined(at(0), at(1)), joined(at(2), at(9)));
  EXPECT_EQ(inside(inner, cube(4)), 3);
  EXPECT_EQ(inside(at(3.4), joined(cube(3), box_soup(Vec3(5, 5, 5), Vec3(6, 6, 6)))), 0)
      << "in the box of both, in neither";
}

// Vertices, edges and faces straight above the sample vertex, and faces without area.
TEST(Containment, SurvivesGrazingRays) {
  EXPECT_EQ(inside(sphere_soup(Vec3::Zero(), 0.5, 2), sphere_soup(Vec3::Zero(), 1, 3)), 1);
  Soup outer = cube(3);
  const Vec3 above(1, 1, 2);
  outer.push_back({above, above, above});
  outer.push_back({above, Vec3(-1, -1, 2), Vec3(-3, -3, 2)});
  EXPECT_EQ(inside(cube(1), outer), 1);
  // On the surface: every ray grazes. The result is meaningless, but the call must end.
  EXPECT_EQ(count_components_inside(Placed(cube(1)), Placed(cube(1))), 0);
}

TEST(Containment, AgreesWithRandomBalls) {
  Source source(kContainmentSeed + 1);
  int cases = 0, hits = 0;
  while (cases < 3000) {
    const std::vector<Ball> outer_balls = random_balls(source, source.integer(1, 5));
    Soup outer_soup;
    for (const Ball& b : outer_balls) outer_soup = joined(outer_soup, soup_of(b));
    const Affine pose = random_affine(source, 10, true);
    const Placed outer(outer_soup, pose);
    for (int i = 0; i < 20; ++i) {
      const Ball ball = random_ball(source, 1);
      const auto clear = [&](const Ball& b) { return clear_of(ball, b); };
      if (!std::all_of(outer_balls.begin(), outer_balls.end(), clear)) continue;
      const Placed inner(soup_of(ball), pose);
      ASSERT_EQ(count_crossings(inner, outer), 0);
      ASSERT_EQ(count_components_inside(inner, outer), truth(ball, outer_balls))
          << "case " << cases << ", seed " << kContainmentSeed + 1;
      ++cases, hits += truth(ball, outer_balls);
    }
  }
  std::printf("seed %u: %.1f %% of %d balls inside\n", kContainmentSeed + 1, 100.0 * hits / cases,
              cases);
  EXPECT_GE(hits, cases / 10);
  EXPECT_LE(hits, cases * 9 / 10);
}

}  // namespace trivet::test
