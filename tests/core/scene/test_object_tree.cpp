// The broad phase against trying all boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/scene/object_tree.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

using Extent = ObjectTree::Extent;
using test::Random;

std::vector<Index> visited(const ObjectTree& tree, const Aabb& box, double margin,
                           int* num_nodes = nullptr) {
  std::vector<Index> out;
  int asked = 0;
  tree.visit(
      [&](const ObjectTree::Extent& there) {
        ++asked;
        return overlaps(there.box, box, margin);
      },
      [&](Index slot) { out.push_back(slot); });
  std::sort(out.begin(), out.end());
  if (num_nodes) *num_nodes = asked;
  return out;
}

/// A tree, and what should be in it.
struct Twin {
  ObjectTree tree;
  std::map<Index, Extent> leaves;

  void set(Index slot, const Extent& extent) {
    tree.set(slot, extent);
    leaves[slot] = extent;
  }
  void erase(Index slot) {
    tree.erase(slot);
    leaves.erase(slot);
  }

  std::vector<Index> near(const Aabb& box, double margin) const {
    std::vector<Index> out;
    for (const auto& [slot, extent] : leaves)
      if (overlaps(extent.box, box, margin)) out.push_back(slot);
    return out;
  }
  Extent without(const std::vector<Index>& slots) const {
    Extent out;
    for (const auto& [slot, extent] : leaves)
      if (std::find(slots.begin(), slots.end(), slot) == slots.end())
        out.unite({extent.box.empty() ? Aabb{} : extent.box,
                   extent.smallest_diagonal > 0 ? extent.smallest_diagonal : kInfinity, 0,
                   extent.coarse_size});
    return out;
  }
};

void expect_same(const Extent& a, const Extent& b) {
  EXPECT_EQ(a.box.lower, b.box.lower);
  EXPECT_EQ(a.box.upper, b.box.upper);
  EXPECT_EQ(a.smallest_diagonal, b.smallest_diagonal);
  EXPECT_EQ(a.coarse_size, b.coarse_size);
}

// Largest allowed height for n leaves: an AVL tree of height h has at least Fibonacci(h + 2) of
// them.
int allowed_height(size_t n) {
  return static_cast<int>(std::floor(1.4405 * std::log2(static_cast<double>(n) + 2)));
}

/// Extents of one kind of scene: spread, in a heap, identical, flat, huge, far out, empty, not a
/// number.
Extent random_extent(Random& random) {
  const double kSize[] = {0.1, 1, 10, 0, 1e15, 1e-3};
  const double size = kSize[random.integer(0, 5)];
  const int kind = random.integer(0, 19);
  const Vec3 half = size * Vec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  Vec3 centre = random.in_cube(10);
  if (kind == 0) return {};
  if (kind == 1) centre = Vec3::Zero();
  if (kind == 2) centre *= 1e15;
  if (kind == 3) centre.z() = std::nan("");
  if (kind == 4) return {{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}, kInfinity};
  if (kind == 5) return {{Vec3::Zero(), Vec3::Ones()}, 1};
  return {{centre - half, centre + half}, 2 * half.norm(), 0, kind < 10 ? 8 * half.norm() : 0};
}

void expect_like_brute_force(const Twin& twin, Random& random, int& num_found) {
  const Vec3 centre = random.in_cube(10), half = Vec3::Constant(random.uniform(0, 3));
  Aabb box{centre - half, centre + half};
  if (random.integer(0, 9) == 0) box = {};
  const double margin = random.integer(0, 1) * random.uniform(0, 0.5);
  const std::vector<Index> found = visited(twin.tree, box, margin);
  EXPECT_EQ(found, twin.near(box, margin));
  num_found += static_cast<int>(found.size());
  expect_same(twin.tree.extent(), twin.without({}));
  std::vector<Index> left_out;
  for (int i = random.integer(0, 6); i > 0; --i) left_out.push_back(random.integer(0, 99));
  expect_same(twin.tree.extent_without(left_out), twin.without(left_out));
}

TEST(ObjectTree, IsEmptyAtFirst) {
  ObjectTree tree;
  EXPECT_EQ(tree.height(), -1);
  EXPECT_TRUE(tree.extent().box.empty());
  EXPECT_TRUE(visited(tree, {Vec3::Zero(), Vec3::Ones()}, 0).empty());
  tree.reserve(3);
  tree.erase(2);
  EXPECT_FALSE(tree.contains(2));
  EXPECT_TRUE(tree.is_valid());
}

TEST(ObjectTree, AnswersLikeBruteForceThroughRandomChanges) {
  int num_found = 0;
  const int num_seeds = test::with_effort(40);
  for (int seed = 0; seed < num_seeds; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Twin twin;
    const int num_slots = random.integer(1, 100);
    twin.tree.reserve(100);
    for (int step = 0; step < 400; ++step) {
      const Index slot = random.integer(0, num_slots - 1);
      if (random.integer(0, 3) == 0)
        twin.erase(slot);
      else
        twin.set(slot, random_extent(random));
      ASSERT_TRUE(twin.tree.is_valid()) << step;
      EXPECT_LE(twin.tree.height(), allowed_height(twin.leaves.size()));
      expect_like_brute_force(twin, random, num_found);
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(num_found, 400 * num_seeds);  // neither all queries nor all scenes are empty
}

TEST(ObjectTree, GivesBackTheSameBoxes) {
  ObjectTree tree;
  tree.reserve(2);
  const Aabb box{Vec3(-0.0, 0.1, 1e15), Vec3(0.3, 0.1, 1e15 + 2)};
  tree.set(1, {box, 0.5});
  EXPECT_EQ(tree.at(1).box.lower, box.lower);
  EXPECT_EQ(tree.at(1).box.upper, box.upper);
  EXPECT_FALSE(tree.contains(0));
  tree.set(1, {{}, 0});
  EXPECT_TRUE(tree.contains(1));
  EXPECT_TRUE(tree.extent().box.empty());
  EXPECT_EQ(tree.extent().smallest_diagonal, kInfinity);
}

TEST(ObjectTree, StaysBalancedWhateverTheOrder) {
  constexpr int kSide = 100, kNumber = kSide * kSide;
  const Vec3 half = Vec3::Constant(0.4);
  const auto at = [&](int order, int i) {
    if (order == 0) return Vec3(i % kSide, i / kSide, 0);       // a grid, row by row
    if (order == 1) return Vec3(i, 0, 0);                       // a row
    if (order == 2) return Vec3(std::ldexp(1, i % 900), 0, 0);  // each farther out than all before
    if (order == 3) return Vec3(0, 0, 0);                       // all in one place
    return Vec3(i % 2 ? i : -i, 0, 0);                          // from the middle outwards
  };
  for (int order = 0; order < 5; ++order) {
    SCOPED_TRACE(order);
    ObjectTree tree;
    tree.reserve(kNumber);
    for (int i = 0; i < kNumber; ++i) tree.set(i, {{at(order, i) - half, at(order, i) + half}, 1});
    EXPECT_TRUE(tree.is_valid());
    EXPECT_LE(tree.height(), allowed_height(kNumber));
    for (int i = 0; i < kNumber; ++i)
      if (i % 100) tree.erase(i);
    EXPECT_TRUE(tree.is_valid());
    EXPECT_LE(tree.height(), allowed_height(kNumber / 100));
  }
}

// Nodes that a query looks at, on average, when it finds what is beside one of n boxes in rows.
// @param table  a box under all of them is there, too.
double nodes_per_query(int n, bool table) {
  ObjectTree tree;
  tree.reserve(n + 1);
  const int side = static_cast<int>(std::ceil(std::sqrt(n)));
  const Vec3 half = Vec3::Constant(0.45);
  const auto box_at = [&](int i) {
    const Vec3 centre(i % side, i / side, 0);
    return Aabb{centre - half, centre + half};
  };
  if (table) tree.set(n, {{-Vec3::Ones(), Vec3(side, side, -0.45)}, 1});
  for (int i = 0; i < n; ++i) tree.set(i, {box_at(i), 1});
  Random random(1);
  double sum = 0;
  constexpr int kQueries = 1000;
  for (int q = 0; q < kQueries; ++q) {
    int num_nodes = 0;
    const size_t num_found =
        visited(tree, box_at(random.integer(0, n - 1)), 0.2, &num_nodes).size();
    EXPECT_GE(num_found, table ? 5u : 4u);  // at a corner
    EXPECT_LE(num_found, table ? 10u : 9u);
    sum += num_nodes;
  }
  return sum / kQueries;
}

TEST(ObjectTree, LooksAtFewNodesHoweverManyThereAre) {
  for (const bool table : {false, true}) {
    const double few = nodes_per_query(100, table), many = nodes_per_query(10000, table);
    const double most = nodes_per_query(100000, table);
    std::printf("nodes per query%s: %.1f of 100, %.1f of 10,000, %.1f of 100,000 boxes\n",
                table ? " over a table" : "", few, many, most);
    EXPECT_LE(most, 4 * few);
  }
}

}  // namespace
}  // namespace trivet
