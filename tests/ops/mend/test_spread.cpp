// Rows moved apart: least shifts for partings, outlines, walls, and turns that are noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/motion/motion.h"
#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"
#include "ops/mend/partings.h"
#include "ops/mend/spread.h"

namespace trivet {
namespace {

using namespace trivet::test;

double sum_of_squares(const std::vector<Vec2>& shifts) {
  double out = 0;
  for (const Vec2& s : shifts) out += s.squaredNorm();
  return out;
}

double most_missing(const std::vector<Parting>& partings, const std::vector<Vec2>& shifts) {
  double out = 0;
  for (const Parting& p : partings) {
    const Vec2 between = p.b ? Vec2(shifts[p.a] - shifts[*p.b]) : shifts[p.a];
    out = std::max(out, p.least - p.way.dot(between));
  }
  return out;
}

TEST(Partings, ARowSpreadsAboutItsMiddleHoweverLong) {
  for (const size_t num : {2, 12, 200}) {
    std::vector<Parting> row;
    for (size_t i = 1; i < num; ++i) row.push_back({i, i - 1, Vec2::UnitX(), 0.001});
    const std::vector<Vec2> shifts = least_shifts(row, num);
    for (size_t i = 0; i < num; ++i)
      EXPECT_NEAR(shifts[i].x(), 0.001 * (static_cast<double>(i) - 0.5 * (num - 1.0)),
                  num < 100 ? 1e-5 : 1e-4)
          << i << " of " << num;
  }
}

TEST(Partings, AWallTakesNoPart) {
  const std::vector<Parting> row{{0, std::nullopt, Vec2::UnitX(), 0.002},
                                 {1, 0, Vec2::UnitX(), 0.001}};
  const std::vector<Vec2> shifts = least_shifts(row, 2);
  EXPECT_NEAR(shifts[0].x(), 0.002, 1e-5);
  EXPECT_NEAR(shifts[1].x(), 0.003, 1e-5);
}

TEST(Partings, NegativeOnesAskForNoMove) {
  const std::vector<Parting> apart{{0, 1, Vec2::UnitX(), -0.01}};
  EXPECT_EQ(sum_of_squares(least_shifts(apart, 2)), 0);
}

// A least solution is shorter than any other that meets the partings: here those of stricter ones.
TEST(Partings, RandomOnesAreMetByTheShortestShifts) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (int run = 0; run < 50; ++run) {
    const size_t num = 6;
    std::vector<Parting> some, stricter;
    for (size_t i = 1; i < num; ++i) {
      const Vec2 way = Vec2(uniform(-1, 1), uniform(0.1, 1)).normalized();
      some.push_back({i, i - 1, way, uniform(-0.005, 0.01)});
      stricter.push_back(some.back());
      stricter.back().least += uniform(0, 0.003);
    }
    const std::vector<Vec2> least = least_shifts(some, num), other = least_shifts(stricter, num);
    EXPECT_LT(most_missing(some, least), 1e-5) << run;
    EXPECT_LE(sum_of_squares(least), sum_of_squares(other) + 1e-8) << run;
  }
}

TEST(Partings, ThoseThatContradictEachOtherEnd) {
  const std::vector<Parting> between_walls{{0, std::nullopt, Vec2::UnitX(), 0.01},
                                           {0, std::nullopt, -Vec2::UnitX(), 0.02}};
  const double x = least_shifts(between_walls, 1)[0].x();
  EXPECT_TRUE(x > -0.021 && x < 0.011) << x;
}

std::vector<Vec2> rectangle(const Vec2& half, const Vec2& at, double turn_deg = 0) {
  const Rotation turn = Rotation::about_axis(Vec3::UnitZ(), turn_time(turn_deg));
  std::vector<Vec2> out;
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    out.push_back(
        at + (turn.matrix() * Vec3(corner.x() * half.x(), corner.y() * half.y(), 0)).head<2>());
  return out;
}

TEST(WayApart, OfRectanglesIsAlongTheNearerSide) {
  const WayApart out = way_apart(rectangle({1, 2}, {1.9, 0.5}), rectangle({1, 2}, {0, 0}));
  EXPECT_NEAR((out.way - Vec2::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR(out.metres, 0.1, 1e-12);
  const WayApart far = way_apart(rectangle({1, 1}, {0, -5}), rectangle({1, 1}, {0, 0}));
  EXPECT_NEAR((far.way + Vec2::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR(far.metres, -3, 1e-12);
}

TEST(TurnToParallel, IsTheSmallestOfFour) {
  const std::vector<Vec2> shelf = rectangle({1, 0.3}, {0, 0}, 10);
  const std::vector<std::pair<double, double>> turns_back{
      {9, 1}, {12, -2}, {-80, 0}, {-78.5, -1.5}, {-4, 14}};
  for (const auto& [turn, back] : turns_back) {
    const auto found = turn_to_parallel(rectangle({0.1, 0.02}, {0.3, 0}, turn), shelf, 15);
    const Rotation by = found.value_or(Rotation());
    const double half = by.z / by.w;
    EXPECT_NEAR((half < 0 ? -1 : 1) * turned_deg(std::abs(half)), back, 1e-6) << turn;
  }
  EXPECT_FALSE(turn_to_parallel(rectangle({0.1, 0.02}, {0, 0}, 30), shelf, 15));
}

TEST(TurnToParallel, RoundThingsHaveNoSides) {
  std::vector<Vec2> round;
  Vec3 rim = Vec3::UnitX();
  for (int k = 0; k < 24;
       ++k, rim = Rotation::about_axis(Vec3::UnitZ(), turn_time(15)).matrix() * rim)
    round.push_back(rim.head<2>());
  EXPECT_FALSE(turn_to_parallel(round, rectangle({1, 0.3}, {0, 0}), 45));
}

/// Books of 30 mm between two walls, and the row's free length.
struct Shelf : Boxes {
  explicit Shelf(double length) {
    add("shelf", {0.5, 0.2, 0.2}, {0, 0, 0.2}, true);
    add("left", {0.01, 0.2, 0.2}, {-0.5 * length - 0.01, 0, 0.6}, true);
    add("right", {0.01, 0.2, 0.2}, {0.5 * length + 0.01, 0, 0.6}, true);
  }
  void fill(int num, double pitch, double turn_deg) {
    for (int i = 0; i < num; ++i)
      books.push_back(
          add("book " + std::to_string(i), {0.015, 0.08, 0.1},
              {pitch * (i - 0.5 * (num - 1)), 0, 0.5}, false,
              Rotation::about_axis(Vec3::UnitZ(), turn_time(i % 2 == 0 ? turn_deg : -turn_deg))));
  }
  std::vector<ObjectId> books;
};

TEST(Mend, ARowThatNearlyFillsItsShelfFits) {
  Shelf s(0.3605);
  s.fill(12, 0.0298, 0);  // 0.2 mm in each other, and 0.5 mm to spare
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_EQ(out.num_kept, out.num_meant);
  for (const SettledObject& o : out.moved) EXPECT_LT(o.moved, 0.0025) << o.name;
}

// Turned by a degree to either side each book takes 2.8 mm more, which the shelf does not have.
TEST(Mend, ARowThatIsTurnedByNoiseIsStraightened) {
  Shelf s(0.365);
  s.fill(12, 0.0303, 1);
  for (size_t i = 0; i < s.books.size(); ++i)  // how far poses are off is told by these
    edit_object(s.scene, s.books[i],
                [&](Object& o) { o.pose.translation.z() += i % 2 == 0 ? 0.001 : -0.001; });
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_EQ(out.num_kept, out.num_meant);
  for (const SettledObject& o : out.moved) EXPECT_LT(o.moved, 0.006) << o.name;
}

TEST(Mend, ARowThatIsTooLongIsNotCalledFree) {
  Shelf s(0.35);
  s.fill(12, 0.029, 0);
  std::vector<Placement> row;
  for (const ObjectId id : s.books) {
    row.push_back({id, s.scene.at(id).pose});
    row.back().pose.translation.z() += 2e-5;
    edit_object(s.scene, id, [](Object& o) { o.placed = false; });
  }
  ShapeFacts facts;
  EXPECT_FALSE(spread_out(s.scene, row, 0.02, facts).free);
  row.pop_back();
  const Spread fits = spread_out(s.scene, row, 0.02, facts);
  EXPECT_TRUE(fits.free);
  EXPECT_LT(fits.farthest, 0.02);
}

TEST(Mend, AThinWallIsNotGoneThrough) {
  Boxes s;
  s.add("shelf", {0.5, 0.2, 0.2}, {0, 0, 0.2}, true);
  s.add("wall", {0.002, 0.2, 0.2}, {0.1, 0, 0.6}, true);
  std::vector<ObjectId> books;
  books.reserve(8);
  for (int i = 0; i < 8; ++i)  // 4 mm in each other: 14 mm to either side
    books.push_back(
        s.add("book " + std::to_string(i), {0.015, 0.08, 0.1}, {0.08 - 0.026 * i, 0, 0.5}));
  MendOptions options;
  options.tolerance = 0.01;
  const MendedScene out = mend_scene(s.scene, options);
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  for (const ObjectId id : books) EXPECT_LT(s.at(id).x(), 0.083) << s.scene.at(id).name;
}

}  // namespace
}  // namespace trivet
