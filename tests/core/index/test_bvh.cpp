#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/index/bvh.h"
#include "core/index/shape.h"
#include "core/mesh/made_meshes.h"

namespace trivet {
namespace {

using namespace trivet::testing;

bool contains(const Aabb& outer, const Aabb& inner) {
  return (outer.lower.array() <= inner.lower.array()).all() &&
         (inner.upper.array() <= outer.upper.array()).all();
}

/// Walks the tree as documented, and checks every guarantee.
class TreeCheck {
 public:
  TreeCheck(const Mesh& mesh, const Bvh& bvh)
      : m_mesh(mesh), m_bvh(bvh), m_uses(mesh.triangles.size()) {}

  void run() {
    ASSERT_FALSE(m_bvh.nodes.empty());
    const Index end = visit(0, 1);
    EXPECT_EQ(end, static_cast<Index>(m_bvh.nodes.size()));
    EXPECT_EQ(m_bvh.faces.size(), m_mesh.triangles.size());
    ASSERT_EQ(m_bvh.slabs.size(), m_bvh.nodes.size());
    EXPECT_EQ(m_next_slot, static_cast<Index>(m_bvh.faces.size()));
    for (const int uses : m_uses) ASSERT_EQ(uses, 1);
    EXPECT_LE(m_depth, kMaxBvhDepth);
  }

  int depth() const { return m_depth; }

 private:
  /// Returns the id after the subtree.
  Index visit(Index id, int depth) {
    m_depth = std::max(m_depth, depth);
    const BvhNode& node = m_bvh.nodes.at(id);
    const Index first_slot = m_next_slot;
    if (node.is_leaf()) {
      visit_leaf(node);
      check_slab(id, first_slot);
      return id + 1;
    }
    const Index second = visit(id + 1, depth + 1);
    EXPECT_EQ(node.second_child, second);
    EXPECT_TRUE(contains(node.box(), m_bvh.nodes.at(id + 1).box()));
    EXPECT_TRUE(contains(node.box(), m_bvh.nodes.at(second).box()));
    const Index end = visit(second, depth + 1);
    check_slab(id, first_slot);
    return end;
  }

  /// The faces from a slot to the next one of the walk are in the slab. (In long double, as the
  /// slab leaves room for the rounding of double alone.)
  void check_slab(Index id, Index first_slot) {
    using Real = long double;
    const BvhSlab& slab = m_bvh.slabs[id];
    const Vec3 centre = m_bvh.nodes[id].box().centre();
    Real squared = 0, lower = slab.lower, upper = slab.upper;
    for (const float n : slab.normal) squared += Real{n} * n;
    EXPECT_LE(squared, 1);
    if (m_next_slot - first_slot > 64 && id % 16 != 0) return;  // enough of the large ones
    for (Index slot = first_slot; slot < m_next_slot; ++slot)
      for (const Vec3& p : m_mesh.triangle(m_bvh.faces[slot])) {
        Real height = 0;
        for (int k = 0; k < 3; ++k) height += slab.normal[k] * (Real{p[k]} - Real{centre[k]});
        lower = std::min(lower, height), upper = std::max(upper, height);
      }
    EXPECT_EQ(lower, slab.lower) << id;
    EXPECT_EQ(upper, slab.upper) << id;
  }

  void visit_leaf(const BvhNode& leaf) {
    EXPECT_LE(leaf.num_faces, kMaxLeafFaces);
    EXPECT_EQ(leaf.second_child, m_next_slot);  // leaf by leaf
    m_next_slot += leaf.num_faces;
    Aabb box;
    for (Index i = 0; i < leaf.num_faces; ++i) {
      const Index face = m_bvh.faces.at(leaf.second_child + i);
      if (i > 0) {
        EXPECT_LT(m_bvh.faces[leaf.second_child + i - 1], face);
      }
      ++m_uses.at(face);
      for (const Vec3& p : m_mesh.triangle(face)) box.extend(p);
    }
    EXPECT_TRUE(contains(leaf.box(), box));
    expect_tight(leaf.box(), box);
  }

  /// Rounded outwards by at most one float.
  void expect_tight(const Aabb& rounded, const Aabb& exact) {
    constexpr float kBig = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const auto lower = static_cast<float>(rounded.lower[axis]);
      const auto upper = static_cast<float>(rounded.upper[axis]);
      EXPECT_GT(std::nextafter(lower, kBig), exact.lower[axis]);
      EXPECT_LT(std::nextafter(upper, -kBig), exact.upper[axis]);
    }
  }

  const Mesh& m_mesh;
  const Bvh& m_bvh;
  std::vector<int> m_uses;
  Index m_next_slot = 0;
  int m_depth = 0;
};

/// Checks the tree; returns its depth.
int check(const Triangles& triangles) {
  const Mesh mesh = weld(triangles);
  const Bvh bvh = build_bvh(mesh);
  TreeCheck tree(mesh, bvh);
  tree.run();
  return tree.depth();
}

bool equal(const Bvh& a, const Bvh& b) {
  const auto same_node = [](const BvhNode& m, const BvhNode& n) {
    return std::tie(m.lower, m.upper, m.second_child, m.num_faces) ==
           std::tie(n.lower, n.upper, n.second_child, n.num_faces);
  };
  return a.faces == b.faces &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node);
}

TEST(Bvh, HasNodesOf32Bytes) { EXPECT_EQ(sizeof(BvhNode), 32u); }

TEST(Bvh, IsEmptyWithoutTriangles) {
  const Bvh bvh = build_bvh({});
  EXPECT_TRUE(bvh.nodes.empty());
  EXPECT_TRUE(bvh.faces.empty());
}

TEST(Bvh, HoldsOneTriangle) {
  const Vec3 a(0.1, 0.2, 0.3), b(0.7, -0.1, 0.2), c(1.0 / 3, 0, 1);
  EXPECT_EQ(check({{a, b, c}}), 1);
}

TEST(Bvh, HoldsOnePoint) {
  EXPECT_EQ(check({Triangle{Vec3::Ones(), Vec3::Ones(), Vec3::Ones()}}), 1);
}

TEST(Bvh, HoldsCube) { check(make_cube()); }

TEST(Bvh, OrdersChildrenAlongAxis) {
  for (const double offset : {-10.0, 10.0})
    for (int axis = 0; axis < 3; ++axis) {
      const Mesh mesh = weld(joined(make_cube(), moved(make_cube(), offset * Vec3::Unit(axis))));
      const Bvh bvh = build_bvh(mesh);
      ASSERT_FALSE(bvh.nodes[0].is_leaf());
      const Aabb first = bvh.nodes[1].box(), second = bvh.nodes[bvh.nodes[0].second_child].box();
      EXPECT_LT(first.upper[axis], second.lower[axis]);
    }
}

/// A tilted square of many faces has a slab without thickness, in every node.
TEST(Bvh, HasThinSlabsOfFlatSurfaces) {
  const Vec3 u = Vec3(1, 2, 3).normalized(), v = Vec3(3, 0, -1).normalized();
  Triangles triangles;
  constexpr int kNum = 40;
  const auto at = [&](int i, int j) { return Vec3(Vec3(5, 6, 7) + 0.1 * (i * u + j * v)); };
  for (int i = 0; i < kNum; ++i)
    for (int j = 0; j < kNum; ++j)
      add_quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  const Bvh bvh = build_bvh(weld(triangles));
  for (const BvhSlab& slab : bvh.slabs) EXPECT_LT(slab.upper - slab.lower, 3e-6);
}

TEST(Bvh, HoldsSoupsOfManySizes) {
  constexpr unsigned kSeed = 11;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const int num_faces : {1, 2, 3, 4, 5, 17, 64, 1000, 30000}) {
    check(make_soup(random, num_faces));
    check(make_tangle(random, num_faces, 1 + num_faces / 3));
  }
}

TEST(Bvh, HandlesAnyUnitAndPlace) {
  constexpr unsigned kSeed = 12;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const double size : {1e-40, 1e-30, 1e-3, 1e3, 1e18, 1e30})
    check(make_soup(random, 2000, size));
  for (const double far : {1e3, 1e6, 1e15}) {
    const int depth = check(make_soup(random, 2000, 1, Vec3(far, -far, far)));
    EXPECT_LT(depth, 40) << far;  // splits are not computed in float32 at the offset
  }
}

TEST(Bvh, HandlesIdenticalTriangles) {
  const Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0.1)};
  EXPECT_LE(check(Triangles(100000, t)), 20);
  const Triangle point{Vec3::Ones(), Vec3::Ones(), Vec3::Ones()};
  EXPECT_LE(check(Triangles(100000, point)), 20);
}

TEST(Bvh, HandlesFanOfLongTriangles) {
  Triangles triangles;
  for (int i = 0; i < 20000; ++i)
    triangles.push_back({Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, i * 1e-4, 0)});
  check(triangles);
}

/// Points along the axes, each at half the distance of the last: a split by surface area removes
/// few of them, so the tree would become too deep.
TEST(Bvh, LimitsDepthForNestedPoints) {
  Triangles triangles;
  double distance = 1;
  for (int i = 0; i < 120; ++i, distance *= 0.5)
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-distance, distance}) {
        const Vec3 p = side * Vec3::Unit(axis);
        triangles.push_back({p, p, p});
      }
  for (int copy = 0; copy < 5000; ++copy)
    triangles.push_back({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  EXPECT_LE(check(triangles), 14);  // by the median builder
}

TEST(Bvh, LimitsDepthForNestedTriangles) {
  Triangles triangles;
  double size = 1;
  for (int i = 0; i < 1000; ++i, size *= 0.9)
    for (int axis = 0; axis < 3; ++axis)
      for (int copy = 0; copy < 4; ++copy)
        triangles.push_back({size * Vec3::Unit(axis), size * Vec3(1, 1, 0), size * Vec3(0, 1, 1)});
  check(triangles);
}

TEST(Bvh, IsTheSameFromManyThreads) {
  constexpr unsigned kSeed = 13;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0.1)};
  for (const Triangles& triangles :
       {make_soup(random, 20000), make_tangle(random, 20000, 50), Triangles(20000, t)}) {
    const Mesh mesh = weld(triangles);
    const Bvh expected = build_bvh(mesh);
    std::vector<int> num_equal(3);
    std::vector<std::thread> threads;
    for (int& count : num_equal)
      threads.emplace_back([&] {
        for (int i = 0; i < 3; ++i) count += equal(build_bvh(mesh), expected);
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(num_equal, std::vector<int>(3, 3));
  }
}

}  // namespace
}  // namespace trivet
