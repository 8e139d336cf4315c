#include <gtest/gtest.h>

#include <thread>

#include "core/index/ray.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

using namespace trivet::test;

bool same(const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->face == b->face;
}

TEST(Ray, EqualsBruteForce) {
  const unsigned seed = 20261121;
  SCOPED_TRACE(seed);
  const MeshPool pool(seed, 3);
  Random random(seed);
  int num_hits = 0;
  constexpr int kNum = 20000;
  for (int i = 0; i < kNum; ++i) {
    const auto& shape = pool.pick(static_cast<MeshKind>(i % kNumMeshKinds), random);
    const Vec3 turn = random.in_cube(1);
    const Pose pose{Rotation{1, turn.x(), turn.y(), turn.z()}.normalized(), random.in_cube(0.5)};
    const Affine world = world_from_object(pose, UpAxis::Z, random.uniform(0.5, 2));
    const Aabb box = shape->box;
    // At a vertex, an edge's middle or a point of the box.
    const Index3& t = shape->mesh.triangles[static_cast<size_t>(
        random.integer(0, static_cast<int>(shape->mesh.triangles.size()) - 1))];
    const Vec3 a = shape->mesh.vertices[t[0]], b = shape->mesh.vertices[t[1]];
    const Vec3 inside = box.centre() + box.half_extent().cwiseProduct(random.in_cube(1));
    const std::array<Vec3, 3> aims{a, 0.5 * (a + b), inside};
    const Vec3 target = world.apply(aims[static_cast<size_t>(i % 3)]);
    Ray ray{target + random.in_cube(3), Vec3::Zero()};
    ray.direction = target - ray.origin;
    if (i % 5 == 0) ray = {target - 2 * Vec3::Unit(i % 3), Vec3::Unit(i % 3)};
    const double until = i % 7 == 0 ? random.uniform(0, 2) : kInfinity;
    const auto fast = first_hit(*shape, world, ray, until);
    ASSERT_TRUE(same(fast, first_hit_brute_force(*shape, world, ray, until))) << i;
    num_hits += fast.has_value();
  }
  EXPECT_GT(num_hits, kNum / 3);
  EXPECT_LT(num_hits, 2 * kNum / 3);
}

TEST(Ray, EqualsBruteForceInAnyUnitAndPlace) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(seed);
  const MeshPool pool(seed, 2);
  Random random(seed);
  int num_hits = 0, num = 0;
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double far : {2.0, 1e3, 1e6, 1e9})
      for (int i = 0; i < 400; ++i, ++num) {
        const auto& shape = pool.pick(static_cast<MeshKind>(i % kNumMeshKinds), random);
        const Affine world =
            world_from_object({random.rotation(), size * far * random.in_cube(1)}, UpAxis::Z, size);
        const auto& vertices = shape->mesh.vertices;
        const Vec3 target = world.apply(vertices[static_cast<size_t>(
            random.integer(0, static_cast<int>(vertices.size()) - 1))]);
        Ray ray{target + size * far * random.direction(), Vec3::Zero()};
        ray.direction = random.uniform(0.1, 10) * (target - ray.origin);
        const auto fast = first_hit(*shape, world, ray);
        ASSERT_TRUE(same(fast, first_hit_brute_force(*shape, world, ray)))
            << size << ' ' << far << ' ' << i;
        num_hits += fast.has_value();
      }
  EXPECT_GT(num_hits, num / 4);
}

TEST(Ray, IsTheSameFromManyThreads) {
  const auto shape = make_shape(weld(bumpy_sphere(60, 120, 0.2, 5)));
  std::vector<int> num_right(4);
  {
    std::vector<std::jthread> threads;
    for (int& right : num_right)
      threads.emplace_back([&] {
        Random random(9);
        for (int i = 0; i < 200; ++i) {
          const Ray ray{3 * random.direction(), random.direction()};
          right +=
              same(first_hit(*shape, Affine{}, ray), first_hit_brute_force(*shape, Affine{}, ray));
        }
      });
  }
  EXPECT_EQ(num_right, std::vector<int>(4, 200));
}

TEST(Ray, DoesNotSlipThroughClosedSurface) {
  const unsigned seed = 7;
  const MeshPool pool(seed, 2);
  Random random(seed);
  for (int i = 0; i < 4000; ++i) {
    const auto& shape = pool.pick(i % 2 ? MeshKind::Box : MeshKind::Sphere, random);
    const Vec3 inside = shape->box.centre();
    const Index3& t = shape->mesh.triangles[static_cast<size_t>(
        random.integer(0, static_cast<int>(shape->mesh.triangles.size()) - 1))];
    const Vec3 vertex = shape->mesh.vertices[t[i % 3]];
    const Ray ray{inside, vertex - inside};
    ASSERT_TRUE(first_hit(*shape, Affine{}, ray)) << i;
  }
}

TEST(Ray, ReportsTimeAndFace) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto shape = make_shape(mesh);
  const auto hit = first_hit(*shape, Affine{}, {Vec3(0.25, 0.25, 2), Vec3(0, 0, -0.5)});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, 4);
  EXPECT_EQ(hit->face, 0);
  EXPECT_FALSE(first_hit(*shape, Affine{}, {Vec3(0.25, 0.25, 2), Vec3(0, 0, 0.5)}));
  EXPECT_FALSE(first_hit(*shape, Affine{}, {Vec3(0.75, 0.75, 2), Vec3(0, 0, -0.5)}));
  EXPECT_FALSE(first_hit(*shape, Affine{}, {Vec3(0.25, 0.25, 2), Vec3(0, 0, -0.5)}, 3.9));
}

}  // namespace
}  // namespace trivet
