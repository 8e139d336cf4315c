#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "core/base/in_parallel.h"
#include "core/base/lazy.h"
#include "core/base/outward.h"
#include "core/index/shape.h"
#include "core/mesh/made_meshes.h"

namespace trivet {
namespace {

using namespace trivet::testing;

TEST(Shape, HoldsCube) {
  const auto shape = make_shape(weld(make_cube()));
  EXPECT_EQ(shape->mesh.vertices.size(), 8u);
  EXPECT_EQ(shape->adjacency.edge_vertices.size(), 18u);
  EXPECT_EQ(shape->mass.rule, MassRule::Volume);
  EXPECT_NEAR(shape->mass.volume, 1, 1e-15);
  EXPECT_FALSE(shape->has_bvh());
  EXPECT_EQ(shape->bvh().faces.size(), 12u);
  EXPECT_EQ(shape->bvh().nodes[0].box().lower, Vec3::Zero());
  EXPECT_EQ(shape->bvh().nodes[0].box().upper, Vec3::Ones());
}

TEST(Shape, HasBoxOfRootWithoutTree) {
  constexpr unsigned kSeed = 21;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const double size : {1e-30, 1e-3, 1.0, 1e30})
    for (const int num_faces : {1, 2, 100}) {
      const auto shape = make_shape(weld(make_soup(random, num_faces, size)));
      const Aabb box = rounded_outwards(shape->box);
      ASSERT_FALSE(shape->has_bvh());
      EXPECT_EQ(box.lower, shape->bvh().nodes[0].box().lower);
      EXPECT_EQ(box.upper, shape->bvh().nodes[0].box().upper);
      EXPECT_TRUE(shape->has_bvh());
    }
}

TEST(Shape, BuildsOneTreeForManyThreads) {
  constexpr unsigned kSeed = 22;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const auto shape = make_shape(weld(make_soup(random, 20000)));
  std::vector<const Bvh*> found(8);
  {
    std::vector<std::jthread> threads;
    for (const Bvh*& tree : found) threads.emplace_back([&] { tree = &shape->bvh(); });
  }
  for (const Bvh* tree : found) EXPECT_EQ(tree, &shape->bvh());
  EXPECT_EQ(shape->bvh().faces.size(), 20000u);
}

/// A thread that waits for Embree must not take up another task that waits for the same tree.
TEST(Shape, BuildsTreesInsideParallelLoops) {
  constexpr unsigned kSeed = 23;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (int round = 0; round < 10; ++round) {
    const std::array shapes{make_shape(weld(make_soup(random, 20000))),
                            make_shape(weld(make_soup(random, 30000)))};
    std::atomic<size_t> sum = 0;
    in_parallel(64, [&](size_t i) { sum += shapes[i % 2]->bvh().faces.size(); });
    EXPECT_EQ(sum, 32u * 50000u);
  }
}

TEST(Lazy, IsMadeByNextCallerAfterException) {
  Lazy<int> value;
  EXPECT_THROW(value.get([]() -> int { throw std::runtime_error("no memory"); }),
               std::runtime_error);
  EXPECT_FALSE(value.is_made());
  EXPECT_EQ(value.get([] { return 7; }), 7);
  EXPECT_EQ(value.get([] { return 8; }), 7);
  EXPECT_TRUE(value.is_made());
}

}  // namespace
}  // namespace trivet
