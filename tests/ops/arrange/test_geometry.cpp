// Regions, outlines, relations and noise against plain truths.
#include <gtest/gtest.h>

#include <cmath>

#include "core/contact/contact_points.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/relations.h"
#include "support/random_shapes.h"
#include "support/solids.h"

namespace trivet {
namespace {

std::vector<Vec2> random_polygon(test::Random& random, const Vec2& at) {
  std::vector<Vec2> points;
  for (int i = 0; i < 8; ++i) points.push_back(at + random.in_cube(0.5).head<2>());
  return convex_hull(points);
}

TEST(Noise, LogarithmIsThatOfLibm) {
  test::Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const double x = std::exp(random.uniform(-700, 700));
    EXPECT_NEAR(natural_logarithm(x), std::log(x), 4e-16 * std::max(1.0, std::abs(std::log(x))));
  }
  EXPECT_EQ(natural_logarithm(1), 0);
}

// Mean of the Gumbel distribution: Euler's constant; variance: pi^2 / 6.
TEST(Noise, IsOfGumbel) {
  double sum = 0, squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double g = gumbel_noise(static_cast<std::uint64_t>(i));
    sum += g, squares += g * g;
  }
  EXPECT_NEAR(sum / kCount, 0.5772, 0.03);
  EXPECT_NEAR(squares / kCount - std::pow(sum / kCount, 2), M_PI * M_PI / 6, 0.06);
}

TEST(ConvexRegion, IsWhatAllHalfPlanesHold) {
  test::Random random(2);
  int num_inside = 0, num_empty = 0;
  for (int i = 0; i < 300; ++i) {
    ConvexRegion region(Vec2(-1, -1), Vec2(1, 1));
    std::vector<HalfPlane> planes;
    for (int k = 0; k < 5; ++k) {
      const Vec2 n = random.direction().head<2>().normalized();
      planes.push_back({n, random.uniform(-0.2, 0.8)});
      region.clip(planes.back());
    }
    num_empty += region.empty();
    for (int k = 0; k < 20; ++k) {
      const Vec2 p = random.in_cube(1).head<2>();
      const bool truth = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& h) {
        return h.normal.dot(p) <= h.bound;
      });
      num_inside += truth;
      if (region.empty()) {
        EXPECT_FALSE(truth);
        continue;
      }
      EXPECT_EQ((region.nearest(p) - p).norm() == 0, truth);
      for (const HalfPlane& h : planes) EXPECT_LE(h.normal.dot(region.nearest(p)), h.bound + 1e-12);
    }
  }
  EXPECT_GT(num_inside, 200);
  EXPECT_GT(num_empty, 5);
}

double to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double t = std::clamp((b - a).dot(p - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

// Distance of all corners from all edges.
double corner_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double out = kInfinity;
  for (size_t s = 0; s < a.size(); ++s)
    for (size_t t = 0; t < b.size(); ++t)
      out = std::min({out, to_segment(a[s], b[t], b[(t + 1) % b.size()]),
                      to_segment(b[t], a[s], a[(s + 1) % a.size()])});
  return out;
}

// By sampling: no two points are nearer, and overlapping polygons share one.
TEST(ConvexRegion, DistanceIsThatOfNearestPoints) {
  test::Random random(3);
  int num_apart = 0;
  for (int i = 0; i < 200; ++i) {
    const auto a = random_polygon(random, Vec2(0, 0));
    const auto b = random_polygon(random, Vec2(random.uniform(-1.5, 1.5), random.uniform(-1, 1)));
    const double d = distance(a, b);
    EXPECT_EQ(d, distance(b, a));
    for (const double enough : {0.1, 0.5, 2.0}) {
      const double bounded = distance(a, b, enough);
      EXPECT_GE(bounded, d);
      EXPECT_EQ(bounded <= enough, d <= enough);
      if (d > enough) {
        EXPECT_EQ(bounded, d);
      }
    }
    double sampled = kInfinity;
    for (size_t s = 0; s < a.size(); ++s)
      for (size_t t = 0; t < b.size(); ++t)
        for (int k = 0; k <= 20; ++k)
          for (int l = 0; l <= 20; ++l)
            sampled = std::min(sampled, (a[s] + k / 20.0 * (a[(s + 1) % a.size()] - a[s]) - b[t] -
                                         l / 20.0 * (b[(t + 1) % b.size()] - b[t]))
                                            .norm());
    EXPECT_LE(d, sampled + 1e-12);
    if (d > 0) {
      EXPECT_NEAR(d, corner_distance(a, b), 1e-14);
      ++num_apart;
    }
  }
  EXPECT_GT(num_apart, 40);
  EXPECT_LT(num_apart, 180);
}

Outline box_outline(const Vec2& at, const Vec2& half, const Vec2& front) {
  Outline out;
  const Vec2 right = quarter_turned(front);
  for (const Vec2& s : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    out.hull.push_back(at + s.x() * half.x() * right - s.y() * half.y() * front);
  out.hull = convex_hull(out.hull);
  out.centre = out.mass_centre = at;
  out.front = front;
  return out;
}

TEST(Outline, OfTurnIsThatOfItsRim) {
  test::Random random(5);
  size_t num_points = 0, num_rim = 0;
  for (int i = 0; i < 100; ++i) {
    const Object object =
        test::object_of("thing", i % 2 ? test::cylinder(0.1, 0.3, 30)
                                       : test::ball(random.uniform(0.05, 0.2), 8, 12));
    const std::vector<Vec3>& points = object.shape->mesh.vertices;
    const Pose lying{random.rotation(), Vec3::Zero()};
    const Vec3 front = -Vec3::UnitY();
    const std::vector<Vec3> rim =
        rim_of(points, object, lying, outline_of(points, object, lying, front));
    num_points += points.size(), num_rim += rim.size();
    const Rotation turn = turned_about_z(random.uniform(0, 360));
    const Pose turned{(turn * lying.rotation).normalized(), Vec3::Zero()};
    const Outline some = outline_of(rim, object, turned, front);
    const Outline all = outline_of(points, object, turned, front);
    EXPECT_NEAR(some.bottom, all.bottom, 1e-15);
    EXPECT_NEAR(some.top, all.top, 1e-15);
    for (int k = 0; k < 16; ++k) {
      const Vec2 d = turned_about_z(22.5 * k).matrix().col(0).head<2>();
      EXPECT_NEAR(some.width(d), all.width(d), 1e-15);
    }
    EXPECT_LT((some.centre - all.centre).norm(), 1e-15);
  }
  EXPECT_LT(num_rim, num_points / 2);
}

TEST(Relations, AreSeenFromInFront) {
  const Outline plate = box_outline(Vec2(1, 2), Vec2(0.1, 0.1), Vec2(0, -1));
  const auto cost = [&]<class K>(K kind, const Vec2& at) {
    kind.lower = 0.05, kind.upper = 0.15;
    Relation r;
    r.kind = kind;
    const Outline cup = box_outline(at, Vec2(0.05, 0.05), Vec2(0, -1));
    return relation_cost(r, cup, &plate);
  };
  // The front looks to -y, to the one who sits there; the right is at +x.
  EXPECT_LT(cost(relations::RightOf(), Vec2(1.25, 2)), 1e-9);
  EXPECT_LT(cost(relations::LeftOf(), Vec2(0.75, 2)), 1e-9);
  EXPECT_LT(cost(relations::InFrontOf(), Vec2(1, 1.75)), 1e-9);
  EXPECT_LT(cost(relations::Behind(), Vec2(1, 2.25)), 1e-9);
  EXPECT_NEAR(cost(relations::RightOf(), Vec2(1.32, 2)), 20, 1e-9);     // gap 0.17
  EXPECT_NEAR(cost(relations::RightOf(), Vec2(1.25, 2.12)), 20, 1e-9);  // overlap 0.03 of 0.05
}

TEST(Relations, TurnTheirCosts) {
  const Outline desk = box_outline(Vec2(0, 0), Vec2(0.8, 0.4), Vec2(0, -1));
  Relation r;
  r.kind = relations::Facing();
  r.tolerance = 5;
  const Outline chair = box_outline(Vec2(0, -1), Vec2(0.3, 0.3), Vec2(0, 1));
  EXPECT_NEAR(relation_cost(r, chair, &desk), 0, 1e-9);
  r.kind = relations::Away();
  EXPECT_NEAR(relation_cost(r, chair, &desk), 36, 1e-9);
  r.kind = relations::Same();
  EXPECT_NEAR(relation_cost(r, chair, &desk), 36, 1e-9);
  r.kind = relations::Parallel();
  EXPECT_NEAR(relation_cost(r, chair, &desk), 0, 1e-9);
  const Outline askew = box_outline(Vec2(0, -1), Vec2(0.3, 0.3), Vec2(0.6, 0.8));
  r.kind = relations::Aligned();
  EXPECT_NEAR(relation_cost(r, askew, &desk), std::atan2(0.6, 0.8) * 180 / M_PI / 5, 1e-9);
}

// Where a relation holds to half its tolerance, its half planes hold: they never hide a place.
TEST(Relations, HalfPlanesHoldWhereTheyDo) {
  using namespace relations;
  const Kind kinds[] = {Against(), Near(),   LeftOf(), RightOf(), InFrontOf(), Behind(),
                        Centred(), AtEdge(), Within(), At(),      Symmetric()};
  test::Random random(4);
  int num_hold = 0, num_planes = 0;
  for (int i = 0; i < 40000; ++i) {
    Relation r;
    r.kind = kinds[random.integer(0, 10)];
    const double lower = random.uniform(0, 0.1), upper = lower + random.uniform(0, 0.4);
    const Side side = static_cast<Side>(random.integer(0, 3));
    r.tolerance = 0.05;
    const Vec2 f = random.direction().head<2>().normalized();
    const Vec2 g = random.direction().head<2>().normalized();
    const Outline moving = box_outline(Vec2(0.02, 0), Vec2(0.2, 0.1), f);
    const Outline other = box_outline(Vec2(0.3, 0.1), Vec2(0.15, 0.3), g);
    const Vec2 at = random.in_cube(0.8).head<2>();
    const Vec2 axis = random.direction().head<2>().normalized();
    const auto set = [&]<class K>(K& kind) {
      if constexpr (requires { kind.lower; }) kind.lower = lower, kind.upper = upper;
      if constexpr (requires { kind.side; }) kind.side = side;
      if constexpr (requires { kind.point; }) kind.point = Vec2(0.1, 0.2);
      if constexpr (requires { kind.region; })
        kind.region = {Vec2(-1, -1), Vec2(1, -0.8), Vec2(0, 1.2)};
      if constexpr (requires { kind.axis; }) kind.axis = axis;
    };
    std::visit(set, r.kind);
    const bool is_of_centre = r.as<At>() || r.as<Symmetric>();
    const bool moves_a = random.integer(0, 1) || r.as<Within>() || is_of_centre;
    const Outline there = moved(moving, at);
    const double cost = moves_a ? relation_cost(r, there, &other) : relation_cost(r, other, &there);
    double worst = -kInfinity;
    for (const HalfPlane& h : half_planes(r, moving, &other, moves_a))
      worst = std::max(worst, h.normal.dot(at) - h.bound), ++num_planes;
    if (cost <= 0.5) {
      EXPECT_LE(worst, 1e-12) << in_english(r.text());
      ++num_hold;
    }
    // These kinds are exact, as the cost is the greatest of their violations.
    const bool exact = !r.as<Near>() && !is_of_centre;
    EXPECT_LE(exact && worst <= 0 ? cost : 0, 0.5 + 1e-9) << in_english(r.text());
    EXPECT_LE(is_decided_by_planes(r) && worst <= 0 ? cost : 0, 1) << in_english(r.text());
  }
  EXPECT_GT(num_hold, 800);
  EXPECT_GT(num_planes, 80000);
}

}  // namespace
}  // namespace trivet
