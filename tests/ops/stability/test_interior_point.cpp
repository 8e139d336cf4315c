// The interior-point method beside the simplex method.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ops/settle/equilibrium.h"
#include "ops/stability/block_factor.h"
#include "ops/stability/fewest_movers.h"
#include "ops/stability/interior_point.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

constexpr double kClearance = 1e-6, kRadius = 0.05;
constexpr int kRows = 8;

struct BallPile {
  double friction = 0.5;
  bool has_walls = true;
  double share = 1;     // of the balls that are there
  double heaviest = 1;  // newtons; the lightest has 1
};

void touch(FreeBodies& pile, Index on, Index from, const Vec3& point, const Vec3& normal,
           double friction) {
  BodyContact t;
  t.on = on, t.from = from, t.friction = friction;
  t.contact.point = point, t.contact.normal = normal, t.contact.gap = 0;
  pile.touches.push_back(t);
}

/// Balls of one size in rows on each other, each in the gap of two below.
FreeBodies pile_of_balls(const BallPile& pile, Random& random) {
  FreeBodies out;
  const double step = 2 * kRadius, rise = std::sqrt(3.0) * kRadius;
  for (int row = 0; row < kRows; ++row)
    for (int k = 0; k < kRows - row; ++k) {
      const bool is_there = random.uniform(0, 1) < pile.share;
      const double weight = random.uniform(1, pile.heaviest);
      if (!is_there) continue;
      const Vec3 centre(step * k + kRadius * row, 0, kRadius + rise * row);
      out.bodies.push_back({{}, centre, weight, 2 * kRadius});
    }
  for (Index i = 0; i < static_cast<Index>(out.bodies.size()); ++i) {
    const Vec3 at = out.bodies[i].centre;
    const double radius = 1.001 * kRadius, last = step * (kRows - 1);
    const auto ground = [&](const Vec3& normal) {
      touch(out, i, BodyContact::kGround, at - kRadius * normal, normal, pile.friction);
    };
    if (at.z() < radius) ground(Vec3::UnitZ());
    if (pile.has_walls && at.x() < radius) ground(Vec3::UnitX());
    if (pile.has_walls && at.x() > last - radius) ground(-Vec3::UnitX());
    for (Index j = i + 1; j < static_cast<Index>(out.bodies.size()); ++j) {
      const Vec3 between = at - out.bodies[j].centre;
      if (between.norm() < 2 * radius)
        touch(out, i, j, at - between / 2, between.normalized(), pile.friction);
    }
  }
  return out;
}

/// Towers of boxes, which touch at their corners: many forces balance, and many motions are alike.
FreeBodies towers_of_boxes(int num_towers, int num_storeys, double lean, double friction) {
  FreeBodies out;
  for (int tower = 0; tower < num_towers; ++tower)
    for (int k = 0; k < num_storeys; ++k) {
      const Vec3 centre(tower + lean * k, 0, k + 0.5);
      const auto box = static_cast<Index>(out.bodies.size());
      out.bodies.push_back({{}, centre, 1, std::sqrt(3.0)});
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) {
          touch(out, box, k == 0 ? BodyContact::kGround : box - 1,
                centre + Vec3(x - (k > 0 && x > 0 ? lean : 0), y, -0.5), Vec3::UnitZ(), friction);
          // The sides of neighbours touch, too, while nothing leans.
          if (tower > 0 && lean == 0)
            touch(out, box, box - num_storeys, centre + Vec3(-0.5, y, x), Vec3::UnitX(), friction);
        }
    }
  return out;
}

/// A ring of wedges, each of which leans on the next, between two abutments.
FreeBodies arch(int num_stones, double friction) {
  FreeBodies out;
  const double step = 3.14159265358979 / num_stones;
  for (Index k = 0; k <= num_stones; ++k) {
    const double angle = step * k;
    const Vec3 along(std::cos(angle), 0, std::sin(angle)), next(-along.z(), 0, along.x());
    if (k < num_stones) {
      const double middle = angle + step / 2;
      out.bodies.push_back({{}, Vec3(std::cos(middle), 0, std::sin(middle)), 1, 0.5});
    }
    for (const double radius : {0.85, 1.15})
      for (const double y : {-0.2, 0.2}) {
        const Vec3 point = radius * along + y * Vec3::UnitY();
        if (k < num_stones)
          touch(out, k, k == 0 ? BodyContact::kGround : k - 1, point, next, friction);
        else
          touch(out, k - 1, BodyContact::kGround, point, -next, friction);
      }
  }
  return out;
}

// Every force is inside its cone and the sums leave no more missing than is told.
void expect_balance(const FreeBodies& pile, const PartForces& found) {
  std::vector<Vec3> force(pile.bodies.size()), torque(pile.bodies.size(), Vec3::Zero());
  std::vector<double> pushes(pile.bodies.size(), 0.0);
  for (size_t i = 0; i < force.size(); ++i) force[i] = Vec3(0, 0, -pile.bodies[i].weight);
  std::vector<BodyContact> all = pile.touches;
  all.insert(all.end(), pile.more.begin(), pile.more.end());
  ASSERT_EQ(all.size(), found.forces.size());
  for (size_t k = 0; k < all.size(); ++k) {
    const BodyContact& t = all[k];
    const double push = t.contact.normal.dot(found.forces[k]);
    EXPECT_LE((found.forces[k] - push * t.contact.normal).norm(), t.friction * push + 1e-12);
    for (const auto& [body, sign] : {std::pair{t.on, 1.0}, std::pair{t.from, -1.0}})
      if (body != BodyContact::kGround) {
        const Vec3 arm = t.contact.point - pile.bodies[body].centre;
        force[body] += sign * found.forces[k];
        torque[body] += sign * arm.cross(found.forces[k]);
        pushes[body] += push;
      }
  }
  for (size_t i = 0; i < force.size(); ++i) {
    const FreeBody& body = pile.bodies[i];
    const double missing = force[i].lpNorm<1>() + torque[i].lpNorm<1>() / body.size;
    EXPECT_LE(missing,
              1e-6 * body.weight + 20 * kClearance / body.size * pushes[i] + 1e-7 * pushes[i]);
  }
}

// A motion that is enough to know who topples says the same, with a proof.
void expect_motion_as_simplex(const FreeBodies& pile, double factor, const PartForces& simplex) {
  const PartForces found = forces_by_interior_point(pile, kClearance, factor, Sought::Motion);
  if (!found.solved) return;
  EXPECT_EQ(found.balanced(), simplex.balanced());
  if (found.balanced()) return expect_balance(pile, found);
  EXPECT_TRUE(proves_lack_of_balance(found.motions, pile, kClearance, factor));
}

enum class Outcome { Stands, Topples, Open };

/// As the simplex method finds it, with the same least sum of what is missing.
Outcome expect_as_simplex(const FreeBodies& pile, double factor = 1) {
  const PartForces found = forces_by_interior_point(pile, kClearance, factor);
  FreeBodies all = pile;
  const PartForces simplex = contact_forces(all, kClearance, factor);
  EXPECT_TRUE(simplex.solved);
  expect_motion_as_simplex(pile, factor, simplex);
  if (!found.solved) {
    // Only what is on the verge is left open.
    EXPECT_LT(simplex.residual, 2 * kMayBeMissing * static_cast<double>(pile.bodies.size()));
    return Outcome::Open;
  }
  EXPECT_EQ(found.balanced(), simplex.balanced());
  if (found.balanced()) {
    expect_balance(pile, found);
    return Outcome::Stands;
  }
  // The interior-point method has for free what may be missing of each body.
  const double free = kMayBeMissing * static_cast<double>(pile.bodies.size());
  EXPECT_NEAR(found.residual, simplex.residual, free + 1e-5 * simplex.residual);
  EXPECT_TRUE(std::find(found.moves.begin(), found.moves.end(), true) != found.moves.end());
  return Outcome::Topples;
}

TEST(InteriorPoint, HoldsPyramidOfBalls) {
  Random random(1);
  EXPECT_EQ(expect_as_simplex(pile_of_balls({}, random)), Outcome::Stands);
}

// Without walls the balls at the ends of the lowest row need friction of tan 15 degrees.
TEST(InteriorPoint, FindsBallsThatRollApart) {
  Random random(1);
  EXPECT_EQ(expect_as_simplex(pile_of_balls({0.1, false}, random)), Outcome::Topples);
}

TEST(InteriorPoint, NamesBallInTheAirAlone) {
  Random random(1);
  FreeBodies pile = pile_of_balls({}, random);
  pile.bodies.push_back({{}, Vec3(0, 0, 2), 1, 2 * kRadius});
  const PartForces found = forces_by_interior_point(pile, kClearance);
  ASSERT_TRUE(found.solved);
  EXPECT_NEAR(found.residual, 1, 1e-6);
  EXPECT_EQ(std::count(found.moves.begin(), found.moves.end(), true), 1);
  EXPECT_TRUE(found.moves.back());
  EXPECT_NEAR(found.motions.back().velocity.z(), -1, 1e-3);
}

TEST(InteriorPoint, FindsWhatSimplexFindsInRandomPiles) {
  Random random(7);
  int counts[3] = {0, 0, 0};
  const int num = std::max(20, with_effort(60));
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    const double friction = random.uniform(0, 0.6), share = random.integer(0, 2) > 0 ? 1 : 0.95;
    const bool has_walls = random.integer(0, 1) > 0;
    FreeBodies pile = pile_of_balls({friction, has_walls, share, random.uniform(1, 5)}, random);
    // Some contacts count only where they are needed.
    while (random.integer(0, 3) > 0) {
      pile.more.push_back(pile.touches.back());
      pile.touches.pop_back();
    }
    ++counts[static_cast<int>(expect_as_simplex(pile, random.integer(0, 1) > 0 ? 1 : 0.99))];
  }
  std::printf("%d stand, %d topple, %d open\n", counts[0], counts[1], counts[2]);
  EXPECT_GE(counts[0], num / 10);
  EXPECT_GE(counts[1], num / 10);
  EXPECT_LE(counts[2], num / 20);
}

TEST(InteriorPoint, FindsWhatSimplexFindsInTowersAndArches) {
  int counts[3] = {0, 0, 0};
  const auto ask = [&](const FreeBodies& pile) {
    ++counts[static_cast<int>(expect_as_simplex(pile))];
  };
  for (const double friction : {0.0, 0.3, 0.5}) {
    SCOPED_TRACE(friction);
    ask(towers_of_boxes(1, 30, 0, friction));
    ask(towers_of_boxes(5, 6, 0, friction));
    // So many overhang together that they fall.
    for (const double lean : {0.01, 0.03, 0.05}) ask(towers_of_boxes(1, 26, lean, friction));
    for (const int num_stones : {5, 9, 25}) ask(arch(num_stones, friction));
  }
  std::printf("%d stand, %d topple, %d open\n", counts[0], counts[1], counts[2]);
  EXPECT_GE(counts[0], 8);
  EXPECT_GE(counts[1], 4);
  EXPECT_EQ(counts[2], 0);
}

// Little more is missing than may be: one of thirty smooth boxes is pushed sideways.
TEST(InteriorPoint, DecidesWhereHardlyAnythingIsMissing) {
  const double tolerated = residual_tolerance(std::sqrt(3.0), kClearance);
  for (const double beyond : {-1e-6, 5e-7, 3e-6, 1e-5, 5e-5, 1e-4}) {
    SCOPED_TRACE(beyond);
    FreeBodies pile = towers_of_boxes(1, 30, 0, 0);
    pile.bodies.back().load = Vec3(tolerated + beyond, 0, 0);
    EXPECT_EQ(expect_as_simplex(pile), beyond < kMayBeMissing ? Outcome::Stands : Outcome::Topples);
  }
}

// Balls at random places in each other, as in a scene that nobody has settled; pairs touch at
// points that are nearly alike.
FreeBodies balls_in_each_other(int count, Random& random) {
  FreeBodies out;
  const auto at = [&] { return random.uniform(0, 12 * kRadius); };
  for (int i = 0; i < count; ++i)
    out.bodies.push_back({{}, Vec3(at(), at(), at()), random.uniform(0.1, 10), 2 * kRadius});
  const auto touch_around = [&](Index i, Index j, const Vec3& point, const Vec3& normal) {
    for (const Vec3& aside : tangents(normal))
      for (const double way : {-0.3, -0.29999, -1e-5, 1e-5, 0.29999, 0.3})
        touch(out, i, j, point + way * kRadius * aside, normal, 0.5);
  };
  for (Index i = 0; i < count; ++i) {
    const Vec3& here = out.bodies[i].centre;
    if (here.z() < kRadius)
      touch_around(i, BodyContact::kGround, Vec3(here.x(), here.y(), 0), Vec3::UnitZ());
    for (Index j = i + 1; j < count; ++j) {
      const Vec3 between = here - out.bodies[j].centre;
      if (between.norm() < 2 * kRadius)
        touch_around(i, j, here - between / 2, between.normalized());
    }
  }
  return out;
}

TEST(InteriorPoint, EndsWhereManyWeightsAreMissing) {
  for (const int seed : {1, 2}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const FreeBodies balls = balls_in_each_other(300, random);
    const PartForces found = forces_by_interior_point(balls, kClearance);
    ASSERT_TRUE(found.solved);
    EXPECT_GT(found.residual, 100);
    EXPECT_TRUE(proves_lack_of_balance(found.motions, balls, kClearance));
  }
}

// Much weight on a feather: rows are in parts of what each body carries.
TEST(InteriorPoint, FindsWhatSimplexFindsWhereWeightsDifferByAThousand) {
  for (const double heavy : {1e-3, 1e3})
    for (const double lean : {0.0, 0.06}) {
      SCOPED_TRACE(heavy);
      FreeBodies pile = towers_of_boxes(1, 26, lean, 0.5);
      for (size_t i = 0; i < pile.bodies.size(); i += 3) pile.bodies[i].weight = heavy;
      EXPECT_NE(expect_as_simplex(pile), Outcome::Open);
    }
}

// To the bit: nothing is remembered from one call to the next.
TEST(InteriorPoint, RepeatsItself) {
  Random random(3);
  const FreeBodies pile = pile_of_balls({0.4, true, 1, 4}, random);
  const PartForces a = forces_by_interior_point(pile, kClearance),
                   b = forces_by_interior_point(pile, kClearance);
  EXPECT_EQ(a.solved, b.solved);
  EXPECT_EQ(a.forces, b.forces);
  EXPECT_EQ(a.moves, b.moves);
}

// A box on the edge of a tower falls alone, whatever else may move in the same motion.
TEST(FewestMovers, AreThoseThatFallWhileAllOthersStandStill) {
  FreeBodies pile = towers_of_boxes(1, 26, 0, 0.5);
  const Index top = 26;
  pile.bodies.push_back({{}, Vec3(0.6, 0, 26.5), 1, std::sqrt(3.0)});
  for (const double x : {0.1, 0.5})
    for (const double y : {-0.5, 0.5})
      touch(pile, top, top - 1, Vec3(x, y, 26), Vec3::UnitZ(), 0.5);
  const PartForces found = forces_by_interior_point(pile, kClearance);
  ASSERT_TRUE(found.solved);
  ASSERT_FALSE(found.balanced());
  EXPECT_EQ(fewest_movers(pile, kClearance, found), std::vector<Index>{top});
}

TEST(FewestMovers, MoveInTheProofToo) {
  Random random(11);
  int num_fewer = 0, num_asked = 0;
  for (int k = 0; k < 20; ++k) {
    const FreeBodies pile =
        pile_of_balls({random.uniform(0, 0.3), random.integer(0, 1) > 0, 0.9, 3}, random);
    const PartForces found = forces_by_interior_point(pile, kClearance);
    if (!found.solved || found.balanced()) continue;
    const std::vector<Index> few = fewest_movers(pile, kClearance, found);
    EXPECT_FALSE(few.empty());
    EXPECT_TRUE(std::is_sorted(few.begin(), few.end()));
    for (const Index i : few) EXPECT_TRUE(found.moves[i]);
    const auto num = static_cast<size_t>(std::count(found.moves.begin(), found.moves.end(), true));
    num_fewer += few.size() < num;
    ++num_asked;
  }
  std::printf("fewer in %d of %d\n", num_fewer, num_asked);
  EXPECT_GT(num_asked, 5);
  EXPECT_GT(num_fewer, 0);
}

// A motion that is nearly the optimum's has the same bodies among the fastest.
TEST(FewestMovers, AreMostlyTheSameByAnyProof) {
  Random random(23);
  int num_same = 0, num_asked = 0;
  for (int k = 0; k < std::max(40, with_effort(100)); ++k) {
    const FreeBodies pile =
        pile_of_balls({random.uniform(0, 0.3), random.integer(0, 1) > 0, 0.9, 3}, random);
    const PartForces optimum = forces_by_interior_point(pile, kClearance),
                     motion = forces_by_interior_point(pile, kClearance, 1, Sought::Motion);
    if (!optimum.solved || optimum.balanced()) continue;
    EXPECT_TRUE(motion.solved);
    num_same += fewest_movers(pile, kClearance, optimum) == fewest_movers(pile, kClearance, motion);
    ++num_asked;
  }
  std::printf("the same in %d of %d\n", num_same, num_asked);
  EXPECT_GT(num_asked, 10);
  EXPECT_GE(num_same, num_asked * 2 / 3);
}

std::vector<ObjectId> numbered(FreeBodies& pile) {
  std::vector<ObjectId> out;
  for (FreeBody& body : pile.bodies) {
    body.id.index = static_cast<std::uint32_t>(out.size());
    out.push_back(body.id);
  }
  return out;
}

TEST(DisproofByFew, IsFoundOnlyWhereNoForcesBalance) {
  Random random(17);
  int num_disproved = 0, num_standing = 0;
  const int num = std::max(40, with_effort(200));
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    FreeBodies pile =
        pile_of_balls({random.uniform(0, 0.4), random.integer(0, 1) > 0, 0.95, 3}, random);
    const std::vector<ObjectId> ids = numbered(pile);
    const ObjectId changed = ids[random.integer(0, static_cast<int>(ids.size()) - 1)];
    const PartForces found = disproof_by_few(pile, {&changed, 1}, kClearance);
    const bool stands = quickest_forces(pile, kClearance).balanced();
    num_standing += stands;
    if (!found.solved) continue;
    ++num_disproved;
    EXPECT_FALSE(stands);
    EXPECT_FALSE(found.balanced());
    EXPECT_LE(std::count(found.moves.begin(), found.moves.end(), true), 8);
  }
  std::printf("%d disproved, %d stand, of %d\n", num_disproved, num_standing, num);
  EXPECT_GE(num_disproved, num / 10);
  EXPECT_GE(num_standing, num / 10);
}

// A box falls off the top of a tower; the lowest ones, which carry it, do not know.
TEST(DisproofByFew, IsFoundNearTheChange) {
  FreeBodies pile = towers_of_boxes(1, 26, 0, 0.5);
  const Index top = 26;
  pile.bodies.push_back({{}, Vec3(0.6, 0, 26.5), 1, std::sqrt(3.0)});
  for (const double x : {0.1, 0.5})
    for (const double y : {-0.5, 0.5})
      touch(pile, top, top - 1, Vec3(x, y, 26), Vec3::UnitZ(), 0.5);
  const std::vector<ObjectId> ids = numbered(pile);
  EXPECT_FALSE(disproof_by_few(pile, {&ids[0], 1}, kClearance).solved);
  const PartForces found = disproof_by_few(pile, {&ids[top], 1}, kClearance);
  ASSERT_TRUE(found.solved);
  EXPECT_TRUE(found.moves[top]);
  EXPECT_EQ(std::count(found.moves.begin(), found.moves.end(), true), 1);
}

// Among ground a feather may be pushed by 20 times its own weight only; it carries a tower.
TEST(DisproofByFew, LetsFeathersCarryTowers) {
  FreeBodies pile = towers_of_boxes(1, 30, 0, 0.5);
  for (Index i = 0; i < 8; ++i) pile.bodies[i].weight = 1e-3;
  const std::vector<ObjectId> ids = numbered(pile);
  EXPECT_FALSE(disproof_by_few(pile, {&ids[0], 1}, kClearance).solved);
  EXPECT_TRUE(quickest_forces(pile, kClearance).balanced());
}

TEST(BlockFactor, SolvesAsTheWholeMatrix) {
  Random random(5);
  constexpr int kRows8 = BlockFactor::kRows;
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 1 + trial;
    const auto random_block = [&] {
      return BlockFactor::Block(BlockFactor::Block::NullaryExpr(
          [&](Eigen::Index, Eigen::Index) { return random.uniform(-1, 1); }));
    };
    std::vector<std::pair<Index, Index>> couplings;
    for (Index a = 0; a < n; ++a)
      for (Index b = 0; b < a; ++b)
        if (random.integer(0, 3) == 0) couplings.emplace_back(a, b);
    BlockFactor factor(static_cast<size_t>(n), couplings);
    factor.set_zero();
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(kRows8 * n, kRows8 * n);
    const auto add = [&](Index a, Index b, const BlockFactor::Block& block) {
      factor.add(a, b, block);
      all.block<kRows8, kRows8>(kRows8 * a, kRows8 * b) += block;
      if (a != b) all.block<kRows8, kRows8>(kRows8 * b, kRows8 * a) += block.transpose();
    };
    for (const auto& [a, b] : couplings) add(a, b, random_block());
    for (Index a = 0; a < n; ++a) {
      const BlockFactor::Block block = random_block();
      add(a, a, block * block.transpose() + 8.0 * n * BlockFactor::Block::Identity());
    }
    std::vector<BlockFactor::Rows> x(static_cast<size_t>(n));
    Eigen::VectorXd b(kRows8 * n);
    for (int a = 0; a < n; ++a) b.segment<kRows8>(kRows8 * a) = x[a] = random_block().col(0);
    factor.factorise();
    factor.solve(x);
    const Eigen::VectorXd expected = all.partialPivLu().solve(b);
    for (int a = 0; a < n; ++a)
      EXPECT_LT((x[a] - expected.segment<kRows8>(kRows8 * a)).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace trivet::test
