#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/mesh/adjacency.h"
#include "core/mesh/made_meshes.h"

namespace trivet {
namespace {

using namespace trivet::testing;
using Ends = std::pair<Index, Index>;

/// Edges in order of use, with their wings, by linear search.
struct SlowEdges {
  std::vector<Ends> edges;
  std::map<Ends, std::vector<std::pair<Index, bool>>> wings;
};

SlowEdges slow_edges(const Mesh& mesh) {
  SlowEdges out;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index from = mesh.triangles[f][k], to = mesh.triangles[f][(k + 1) % 3];
      if (from == to) continue;
      const Ends ends = std::minmax(from, to);
      if (!out.wings.count(ends)) out.edges.push_back(ends);
      out.wings[ends].emplace_back(f, from < to);
    }
  return out;
}

void check_edges(const Mesh& mesh, const Adjacency& adjacency) {
  const SlowEdges slow = slow_edges(mesh);
  ASSERT_EQ(adjacency.edge_vertices.size(), slow.edges.size());
  ASSERT_EQ(adjacency.edge_faces.size(), static_cast<Index>(slow.edges.size()));
  for (Index e = 0; e < static_cast<Index>(slow.edges.size()); ++e) {
    ASSERT_EQ(adjacency.edge_vertices[e][0], slow.edges[e].first);
    ASSERT_EQ(adjacency.edge_vertices[e][1], slow.edges[e].second);
    std::vector<std::pair<Index, bool>> wings;
    for (const Wing& wing : adjacency.edge_faces[e]) wings.emplace_back(wing.face, wing.forward);
    ASSERT_EQ(wings, slow.wings.at(slow.edges[e]));
  }
  ASSERT_EQ(adjacency.face_edges.size(), mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index from = mesh.triangles[f][k], to = mesh.triangles[f][(k + 1) % 3];
      const Index edge = adjacency.face_edges[f][k];
      ASSERT_EQ(edge < 0, from == to);
      if (edge >= 0) {
        ASSERT_EQ(slow.edges[edge], Ends(std::minmax(from, to)));
      }
    }
}

void check_vertex_rows(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<std::set<Index>> faces(mesh.vertices.size()), edges(mesh.vertices.size());
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
    for (const Index v : mesh.triangles[f]) faces[v].insert(f);
  for (Index e = 0; e < static_cast<Index>(adjacency.edge_vertices.size()); ++e)
    for (const Index v : adjacency.edge_vertices[e]) edges[v].insert(e);
  ASSERT_EQ(adjacency.vertex_faces.size(), static_cast<Index>(mesh.vertices.size()));
  ASSERT_EQ(adjacency.vertex_edges.size(), static_cast<Index>(mesh.vertices.size()));
  for (Index v = 0; v < static_cast<Index>(mesh.vertices.size()); ++v) {
    const auto face_row = adjacency.vertex_faces[v], edge_row = adjacency.vertex_edges[v];
    ASSERT_TRUE(std::equal(face_row.begin(), face_row.end(), faces[v].begin(), faces[v].end()));
    ASSERT_TRUE(std::equal(edge_row.begin(), edge_row.end(), edges[v].begin(), edges[v].end()));
  }
}

/// Propagates the smallest face id over shared edges until it converges.
std::vector<Index> slow_labels(const Mesh& mesh) {
  const SlowEdges slow = slow_edges(mesh);
  std::vector<Index> label(mesh.triangles.size());
  std::iota(label.begin(), label.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [ends, wings] : slow.wings) {
      Index least = label[wings[0].first];
      for (const auto& [face, forward] : wings) least = std::min(least, label[face]);
      for (const auto& [face, forward] : wings) {
        changed = changed || label[face] != least;
        label[face] = least;
      }
    }
  }
  return label;
}

void check_components(const Mesh& mesh, const Adjacency& adjacency) {
  const std::vector<Index> labels = slow_labels(mesh);
  std::map<Index, Component> slow;
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    Component& c = slow[labels[f]];
    ++c.num_faces;
    for (const Vec3& p : mesh.triangle(static_cast<Index>(f))) c.box.extend(p);
  }
  for (const auto& [ends, wings] : slow_edges(mesh).wings) {
    Component& c = slow[labels[wings[0].first]];
    const size_t forward =
        std::count_if(wings.begin(), wings.end(), [](auto& w) { return w.second; });
    c.even &= wings.size() % 2 == 0;
    c.balanced &= 2 * forward == wings.size();
    c.manifold &= wings.size() == 2 && forward == 1;
  }
  ASSERT_EQ(adjacency.components.size(), slow.size());
  Index id = 0;
  for (const auto& [label, expected] : slow) {  // ascending: in the order of the first faces
    const Component& c = adjacency.components[id];
    ASSERT_EQ(c.num_faces, expected.num_faces);
    ASSERT_EQ(c.box.lower, expected.box.lower);
    ASSERT_EQ(c.box.upper, expected.box.upper);
    ASSERT_EQ(std::tie(c.even, c.balanced, c.manifold),
              std::tie(expected.even, expected.balanced, expected.manifold));
    const auto& corners = mesh.triangles[label];
    ASSERT_NE(std::find(corners.begin(), corners.end(), c.sample_vertex), corners.end());
    for (size_t f = 0; f < labels.size(); ++f)
      ASSERT_EQ(labels[f] == label, adjacency.face_component[f] == id);
    ++id;
  }
}

void check_all(const Mesh& mesh) {
  const Adjacency adjacency = make_adjacency(mesh);
  check_edges(mesh, adjacency);
  check_vertex_rows(mesh, adjacency);
  check_components(mesh, adjacency);
}

TEST(Adjacency, IsEmptyForEmptyMesh) {
  const Adjacency adjacency = make_adjacency({});
  EXPECT_EQ(adjacency.edge_faces.size(), 0);
  EXPECT_TRUE(adjacency.components.empty());
}

TEST(Adjacency, ConnectsCube) {
  const Mesh mesh = weld(make_cube());
  const Adjacency adjacency = make_adjacency(mesh);
  EXPECT_EQ(adjacency.edge_vertices.size(), 18u);  // Euler: 8 - 18 + 12 = 2
  ASSERT_EQ(adjacency.components.size(), 1u);
  EXPECT_TRUE(adjacency.components[0].manifold);
  EXPECT_EQ(adjacency.components[0].num_faces, 12);
  check_all(mesh);
}

TEST(Adjacency, SeparatesCubesJoinedAtVertex) {
  const Mesh mesh = weld(joined(make_cube(), moved(make_cube(), Vec3::Ones())));
  EXPECT_EQ(mesh.vertices.size(), 15u);
  EXPECT_EQ(make_adjacency(mesh).components.size(), 2u);
  check_all(mesh);
}

TEST(Adjacency, CallsCubesJoinedAtEdgeBalancedNotManifold) {
  const Mesh mesh = weld(joined(make_cube(), moved(make_cube(), Vec3(1, 1, 0))));
  const Adjacency adjacency = make_adjacency(mesh);
  ASSERT_EQ(adjacency.components.size(), 1u);
  EXPECT_TRUE(adjacency.components[0].even);
  EXPECT_TRUE(adjacency.components[0].balanced);
  EXPECT_FALSE(adjacency.components[0].manifold);
  check_all(mesh);
}

TEST(Adjacency, KeepsParityOfFlippedFace) {
  Triangles triangles = make_cube();
  std::swap(triangles[3][0], triangles[3][1]);
  const Adjacency adjacency = make_adjacency(weld(triangles));
  ASSERT_EQ(adjacency.components.size(), 1u);
  EXPECT_TRUE(adjacency.components[0].even);
  EXPECT_FALSE(adjacency.components[0].balanced);
}

TEST(Adjacency, CallsOpenBoxNotEven) {
  Triangles triangles = make_cube();
  triangles.erase(triangles.begin(), triangles.begin() + 2);
  EXPECT_FALSE(make_adjacency(weld(triangles)).components[0].even);
}

TEST(Adjacency, OmitsEdgeBetweenEqualCorners) {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  const Mesh mesh = weld({{a, a, b}, {b, b, b}});
  const Adjacency adjacency = make_adjacency(mesh);
  EXPECT_EQ(adjacency.face_edges, (std::vector<Index3>{{-1, 0, 0}, {-1, -1, -1}}));
  EXPECT_EQ(adjacency.components.size(), 2u);
  EXPECT_TRUE(adjacency.components[0].manifold);  // there and back
  EXPECT_EQ(adjacency.vertex_faces[0].size(), 1u);
  EXPECT_EQ(adjacency.vertex_faces[1].size(), 2u);
  check_all(mesh);
}

TEST(Adjacency, HandlesDuplicateFaces) {
  const Mesh mesh = weld(joined(make_cube(), make_cube()));
  const Adjacency adjacency = make_adjacency(mesh);
  EXPECT_TRUE(adjacency.components[0].balanced);
  EXPECT_FALSE(adjacency.components[0].manifold);
  check_all(mesh);
}

/// All faces at one edge: the cost must not be quadratic.
TEST(Adjacency, IsLinearForFanOfFaces) {
  constexpr int kFaces = 100000;
  Triangles triangles;
  for (int i = 0; i < kFaces; ++i)
    triangles.push_back({Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, i, 0)});
  const Mesh mesh = weld(triangles);
  const Adjacency adjacency = make_adjacency(mesh);
  EXPECT_EQ(adjacency.edge_faces[0].size(), static_cast<size_t>(kFaces));
  EXPECT_EQ(adjacency.edge_vertices.size(), 2u * kFaces + 1);
  EXPECT_EQ(adjacency.components.size(), 1u);
  EXPECT_FALSE(adjacency.components[0].even);
}

TEST(Adjacency, AgreesWithLinearSearchOnTangles) {
  constexpr unsigned kSeed = 2;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  int num_edges = 0, num_crowded = 0, num_components = 0;
  for (int round = 0; round < 200; ++round) {
    const int num_faces = 1 + static_cast<int>(random() % 120);
    const int num_points = 1 + static_cast<int>(random() % 60);
    const Mesh mesh = weld(make_tangle(random, num_faces, num_points));
    SCOPED_TRACE(round);
    check_all(mesh);
    if (HasFatalFailure()) return;
    const Adjacency adjacency = make_adjacency(mesh);
    num_components += static_cast<int>(adjacency.components.size());
    for (Index e = 0; e < adjacency.edge_faces.size(); ++e) {
      ++num_edges;
      num_crowded += adjacency.edge_faces[e].size() > 2;
    }
  }
  EXPECT_GT(num_crowded, num_edges / 50);  // guards that tangles are crowded
  EXPECT_LT(num_crowded, num_edges / 2);
  EXPECT_GT(num_components, 400);
}

}  // namespace
}  // namespace trivet
