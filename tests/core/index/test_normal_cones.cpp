// Cones hold all directions in which nothing beside a feature rises.

#include <gtest/gtest.h>

#include "core/base/tunables.h"
#include "core/index/normal_cones.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

/// @param inside  by how much, of the cosine.
bool holds(const NormalCone& cone, const Vec3& d, double inside = 0) {
  if (cone.is_none()) return false;
  return cone.cos <= -1 ||
         Vec3(cone.axis[0], cone.axis[1], cone.axis[2]).dot(d) >= cone.cos + inside;
}

bool holds(const NormalCones::Part& part, const Vec3& d) {
  return holds(part.outwards, d) || holds(part.inwards, d);
}

bool rises(const Vec3& from, const Vec3& to, const Vec3& d) {
  return d.dot(to - from) > kConeSlope * (to - from).norm();
}

bool rises_beside_vertex(const Shape& shape, Index v, const Vec3& d) {
  const auto& p = shape.mesh.vertices;
  for (const Index e : shape.adjacency.vertex_edges[v])
    for (const Index end : shape.adjacency.edge_vertices[e])
      if (rises(p[v], p[end], d)) return true;
  return false;
}

bool rises_beside_edge(const Shape& shape, Index e, const Vec3& at, const Vec3& d) {
  for (const Wing& wing : shape.adjacency.edge_faces[e])
    for (const Index v : shape.mesh.triangles[wing.face])
      if (rises(at, shape.mesh.vertices[v], d)) return true;
  return false;
}

/// A direction along the face's normal, nearly, or across one of its edges, or any.
Vec3 direction_near(const Triangle& t, test::Random& random) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const int kind = random.integer(0, 3);
  if (kind == 3 || !(normal.norm() > 0)) return random.direction();
  const double off = kind == 0 ? 2e-3 : kind == 1 ? 0.1 : 0.7;
  const double sign = random.integer(0, 3) == 0 ? -1 : 1;
  Vec3 out = sign * (normal.normalized() + off * random.direction());
  const Vec3 edge = t[1] - t[0];
  if (random.integer(0, 1) == 0) out -= out.dot(edge) / edge.squaredNorm() * edge;
  return out.normalized();
}

class ConeCheck {
 public:
  explicit ConeCheck(const Shape& shape)
      : m_shape(shape), m_bvh(shape.bvh()), m_cones(normal_cones_of(shape)) {}

  void check_face(Index f, const Vec3& d, test::Random& random) {
    const Index3 &corners = m_shape.mesh.triangles[f], &edges = m_shape.adjacency.face_edges[f];
    bool is_free = false;
    const auto note = [&](bool rises, const NormalCones::Part& feature) {
      is_free = is_free || !rises;
      EXPECT_TRUE(rises || holds(feature, d)) << "face " << f << ": " << d.transpose();
    };
    const auto& p = m_shape.mesh.vertices;
    for (int k = 0; k < 3; ++k) {
      const bool rises = rises_beside_vertex(m_shape, corners[k], d);
      note(rises, m_cones.vertices[corners[k]]);
      if (edges[k] < 0) continue;
      // Ends of edges touch as their vertices do.
      EXPECT_TRUE(rises || holds(m_cones.edges[edges[k]], d));
      const Vec3 along = p[corners[(k + 1) % 3]] - p[corners[k]];
      const Vec3 at = p[corners[k]] + random.uniform(0.01, 0.99) * along;
      note(rises_beside_edge(m_shape, edges[k], at, d), m_cones.edges[edges[k]]);
    }
    num_free += is_free;
    num_held += holds(m_cones.faces[f], random.direction());
    ++num_asked;
    EXPECT_TRUE(!is_free || holds(m_cones.faces[f], d)) << "face " << f << ": " << d.transpose();
  }

  // A node's cones hold those of its parts.
  void check_nodes(const Vec3& d) const {
    for (Index id = 0; id < static_cast<Index>(m_bvh.nodes.size()); ++id) {
      const BvhNode& node = m_bvh.nodes[id];
      if (!node.is_leaf()) {
        expect_within(m_cones.nodes[id + 1], m_cones.nodes[id], d);
        expect_within(m_cones.nodes[node.second_child], m_cones.nodes[id], d);
      }
      for (Index i = 0; i < node.num_faces; ++i)
        expect_within(m_cones.faces[m_bvh.faces[node.second_child + i]], m_cones.nodes[id], d);
    }
  }

  void check_normal(Index f) const {
    const Triangle t = m_shape.mesh.triangle(f);
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    EXPECT_TRUE(!(normal.norm() > 0) || holds(m_cones.faces[f].normals, normal.normalized()));
  }

  int num_free = 0, num_held = 0, num_asked = 0;

 private:
  static void expect_within(const NormalCones::Part& part, const NormalCones::Part& whole,
                            const Vec3& d) {
    const double rounding = 1e-6;  // of floats
    EXPECT_TRUE(!holds(part.outwards, d, rounding) || holds(whole.outwards, d));
    EXPECT_TRUE(!holds(part.inwards, d, rounding) || holds(whole.inwards, d));
    EXPECT_TRUE(!holds(part.normals, d, rounding) || holds(whole.normals, d));
  }

  const Shape& m_shape;
  const Bvh& m_bvh;
  const NormalCones& m_cones;
};

TEST(NormalCones, HoldAllDirectionsInWhichNothingRises) {
  constexpr unsigned kSeed = 47;
  const test::MeshPool pool(kSeed, 6);
  test::Random random(kSeed);
  int num_free = 0, num_spared = 0, num_asked = 0;
  for (int i = 0; i < test::with_effort(96); ++i) {
    const auto kind = static_cast<test::MeshKind>(i % test::kNumMeshKinds);
    const auto& shape = pool.pick(kind, random);
    ConeCheck check(*shape);
    const auto num_faces = static_cast<int>(shape->mesh.triangles.size());
    for (int k = 0; k < 400; ++k) {
      const auto f = static_cast<Index>(random.integer(0, num_faces - 1));
      const Vec3 d = direction_near(shape->mesh.triangle(f), random);
      if (!(d.norm() > 0.5)) continue;
      check.check_face(f, d, random);
      check.check_normal(f);
      if (k % 40 == 0) check.check_nodes(d);
    }
    num_free += check.num_free;
    if (kind != test::MeshKind::Sphere && kind != test::MeshKind::Terrain) continue;
    num_spared += check.num_asked - check.num_held;
    num_asked += check.num_asked;
  }
  std::printf("seed %u: %d free, %d of %d spared\n", kSeed, num_free, num_spared, num_asked);
  EXPECT_GT(num_free, 20 * test::with_effort(96));
  // They are not all directions.
  EXPECT_GT(num_spared, num_asked / 3);
}

// Features of a cube's side look away from it, and into it.
TEST(NormalCones, OfACubeAreThoseOfItsCorners) {
  const auto cube = test::shape_of(test::box_triangles(Vec3(1, 1, 1)));
  const NormalCones& cones = normal_cones_of(*cube);
  for (Index f = 0; f < 12; ++f) {
    const Triangle t = cube->mesh.triangle(f);
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    EXPECT_TRUE(holds(cones.faces[f].outwards, normal));
    EXPECT_FALSE(holds(cones.faces[f].normals, -normal));
    // Diagonals of a flat side rise on neither side.
    EXPECT_TRUE(holds(cones.faces[f].inwards, -normal));
    EXPECT_FALSE(holds(cones.faces[f].outwards, -normal));
  }
}

}  // namespace
}  // namespace trivet
