#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

#include "core/index/box_pairs.h"

namespace trivet {
namespace {

using Pairs = std::set<std::pair<Index, Index>>;

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

struct Boxes {
  std::vector<Aabb> a, b;
};

/// Boxes of many sizes, some flat, some a point, some equal.
std::vector<Aabb> random_boxes(std::mt19937& random, int num, double size, const Vec3& at) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Aabb> out;
  for (int i = 0; i < num; ++i) {
    const Vec3 lower(unit(random), unit(random), unit(random));
    Vec3 extent = 0.3 * unit(random) * Vec3(unit(random), unit(random), unit(random));
    if (i % 3 == 0) extent[i % 2] = 0;
    if (i % 7 == 0) extent.setZero();
    out.push_back({at + size * lower, at + size * (lower + extent)});
    if (i % 11 == 0) out.back() = out[out.size() / 2];
  }
  return out;
}

Pairs all_overlaps(const Boxes& boxes) {
  Pairs out;
  for (Index i = 0; i < static_cast<Index>(boxes.a.size()); ++i)
    for (Index j = 0; j < static_cast<Index>(boxes.b.size()); ++j)
      if (overlaps(boxes.a[i], boxes.b[j])) out.insert({i, j});
  return out;
}

Pairs reported(const Boxes& boxes) {
  Pairs out;
  const auto visit = [&](const BoxPair& p) { EXPECT_TRUE(out.insert({p.a, p.b}).second); };
  EXPECT_TRUE(visit_overlapping_boxes(boxes.a, boxes.b, kNoLimit, visit));
  return out;
}

void expect_right(const Boxes& boxes) {
  const Pairs expected = all_overlaps(boxes), found = reported(boxes);
  EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
  EXPECT_LE(found.size(), expected.size() + expected.size() / 100 + 2);
}

TEST(BoxPairs, EqualBruteForceInAnyUnitAndPlace) {
  constexpr unsigned kSeed = 31;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const double size : {1e-40, 1e-3, 1.0, 1e30})
    for (const double far : {0.0, 1e3, 1e9})
      for (const int num : {1, 3, 40, 700}) {
        SCOPED_TRACE(testing::Message() << size << ' ' << far << ' ' << num);
        const Vec3 at = size * far * Vec3(1, -1, 1);
        expect_right(
            {random_boxes(random, num, size, at), random_boxes(random, 2 * num, size, at)});
      }
}

TEST(BoxPairs, TouchingBoxesOverlap) {
  const Aabb box{Vec3::Zero(), Vec3::Ones()};
  Boxes boxes{{box}, {}};
  for (int k = 0; k < 3; ++k)
    for (const double shift : {-1.0, 1.0})
      boxes.b.push_back({box.lower + shift * Vec3::Unit(k), box.upper + shift * Vec3::Unit(k)});
  EXPECT_EQ(reported(boxes).size(), 6u);
}

TEST(BoxPairs, AcceptsInfiniteBoxesAndNone) {
  const Aabb all{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
  const Aabb box{Vec3::Zero(), Vec3::Ones()}, point{Vec3::Ones(), Vec3::Ones()};
  EXPECT_EQ(reported({{all, point}, {box, point}}).size(), 4u);
  EXPECT_TRUE(reported({{}, {box}}).empty());
  EXPECT_TRUE(reported({{all}, {}}).empty());
}

TEST(BoxPairs, GivesUpWhenThereAreManyMorePairsThanAccepted) {
  const std::vector<Aabb> same(2000, Aabb{Vec3::Zero(), Vec3::Ones()});
  size_t num_visited = 0;
  const auto visit = [&](const BoxPair&) { ++num_visited; };
  EXPECT_FALSE(visit_overlapping_boxes(same, same, 100'000, visit));
  EXPECT_EQ(num_visited, 0u);
  EXPECT_TRUE(visit_overlapping_boxes(same, std::span(same).first(10), 100'000, visit));
  EXPECT_EQ(num_visited, 20'000u);
}

TEST(BoxPairs, AreTheSameFromManyThreads) {
  constexpr unsigned kSeed = 32;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const Boxes boxes{random_boxes(random, 3000, 1, Vec3::Zero()),
                    random_boxes(random, 3000, 1, Vec3::Zero())};
  const Pairs expected = reported(boxes);
  std::vector<char> right(4);
  {
    std::vector<std::jthread> threads;
    for (char& r : right) threads.emplace_back([&] { r = reported(boxes) == expected; });
  }
  EXPECT_EQ(right, std::vector<char>(4, 1));
}

}  // namespace
}  // namespace trivet
