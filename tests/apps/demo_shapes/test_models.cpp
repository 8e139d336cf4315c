#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "apps/demo/shapes/assemble.h"
#include "apps/demo/shapes/models.h"
#include "core/base/error.h"
#include "core/exact/predicates.h"
#include "core/mesh/mass.h"

namespace trivet::shapes {
namespace {

/// Expected properties: triangles, size of its box in metres, number of closed surfaces.
struct Expected {
  int min_triangles, max_triangles;
  Vec3 min_size, max_size;
  int num_components = 1;
};

const std::map<std::string, Expected>& expectations() {
  static const std::map<std::string, Expected> table{
      {"saucer", {500, 660, {.14, .14, .015}, {.16, .16, .03}}},
      {"spoon", {280, 380, {.13, .025, .01}, {.19, .04, .03}}},
      {"plate", {600, 900, {.21, .21, .015}, {.26, .26, .035}}},
      {"cup", {700, 1000, {.09, .075, .05}, {.12, .09, .09}, 2}},
      {"glass", {500, 800, {.06, .06, .09}, {.08, .08, .14}}},
      {"bowl", {800, 1200, {.22, .22, .07}, {.28, .28, .12}}},
      {"egg_cup", {450, 750, {.04, .04, .04}, {.06, .06, .07}}},
      {"teapot", {1500, 2200, {.2, .12, .12}, {.3, .18, .2}, 3}},
      {"jug", {800, 1200, {.1, .07, .09}, {.14, .1, .14}, 2}},
      {"knife", {180, 320, {.19, .015, .005}, {.24, .03, .02}}},
      {"apple", {500, 750, {.065, .065, .07}, {.085, .085, .09}, 2}},
      {"banana", {350, 600, {.15, .04, .03}, {.2, .09, .045}}},
      {"egg", {300, 500, {.04, .04, .05}, {.05, .05, .065}}},
      {"toast", {180, 350, {.08, .08, .01}, {.12, .12, .02}}},
      {"loaf", {300, 700, {.18, .09, .09}, {.25, .13, .13}}},
      {"table", {700, 1200, {1.19, .79, .74}, {1.3, .8, .76}, 10}},
      {"bare_table", {250, 700, {1.19, .79, .739}, {1.21, .81, .741}, 9}},
      {"pegs", {150, 500, {.89, .1, 1.74}, {.91, .14, 1.76}, 5}},
      {"desk", {900, 1400, {1.4, .69, .729}, {1.6, .76, .731}, 10}},
      {"bookcase", {300, 500, {.7, .3, 1.1}, {.75, .35, 1.2}, 8}},
      {"chair", {3000, 4500, {.6, .5, .9}, {.7, .65, 1.05}, 24}},
      {"monitor", {500, 800, {.5, .15, .4}, {.6, .25, .5}, 24}},
      {"keyboard", {1200, 1600, {.42, .13, .02}, {.46, .15, .03}, 107}},
      {"mouse", {500, 800, {.055, .1, .03}, {.07, .12, .04}, 2}},
      {"telephone", {1300, 1900, {.2, .22, .1}, {.22, .27, .14}, 20}},
      {"lamp", {2000, 2800, {.3, .16, .4}, {.42, .19, .5}, 10}},
      {"book_red", {300, 500, {.03, .15, .23}, {.04, .18, .25}, 4}},
      {"book_blue", {300, 500, {.02, .14, .2}, {.03, .17, .23}, 4}},
      {"book_green", {300, 500, {.035, .16, .24}, {.045, .19, .26}, 4}},
      {"book_yellow", {280, 450, {.015, .12, .19}, {.025, .15, .21}, 4}},
      {"binder", {350, 600, {.07, .28, .31}, {.08, .3, .32}, 5}},
      {"letter", {1800, 2600, {.2099, .2969, .01}, {.2101, .2971, .03}}},
      {"report", {1800, 2600, {.2099, .2969, .01}, {.2101, .2971, .035}}},
      {"paper_ball", {150, 300, {.055, .055, .055}, {.076, .076, .076}}},
      {"mug", {1200, 1800, {.1, .08, .09}, {.13, .09, .1}, 2}},
      {"pencil", {60, 120, {.17, .0079, .0068}, {.18, .0081, .007}}},
      {"pen", {250, 400, {.13, .01, .01}, {.15, .013, .014}, 3}},
      {"waste_basket", {800, 1200, {.27, .27, .24}, {.3, .3, .26}}},
      {"plant", {1800, 2600, {.28, .28, .3}, {.36, .36, .4}, 16}},
      {"wall", {12, 12, {3.19, .11, 2.09}, {3.21, .13, 2.11}}},
      {"shop_shelf", {80, 120, {.93, .39, 1.71}, {.95, .41, 1.73}, 8}},
      {"can_red", {250, 350, {.073, .073, .109}, {.075, .075, .111}}},
      {"can_green", {250, 350, {.073, .073, .109}, {.075, .075, .111}}},
      {"tin", {250, 350, {.083, .083, .044}, {.085, .085, .046}}},
      {"carton", {12, 12, {.069, .069, .204}, {.071, .071, .206}}},
      {"cereal", {12, 12, {.189, .064, .284}, {.191, .066, .286}}},
      {"soap", {12, 12, {.084, .054, .034}, {.086, .056, .036}}},
      {"jar", {350, 500, {.068, .068, .107}, {.07, .07, .109}}},
      {"bottle", {450, 650, {.074, .074, .255}, {.076, .076, .257}}},
      {"workbench", {72, 72, {1.49, .63, .879}, {1.51, .65, .881}, 6}},
      {"parts_bin", {60, 60, {.299, .219, .089}, {.301, .221, .091}, 5}},
      {"bolt", {80, 120, {.044, .018, .016}, {.046, .02, .018}, 2}},
      {"nut", {40, 60, {.018, .016, .0079}, {.02, .018, .0081}}},
      {"bracket", {24, 24, {.039, .024, .034}, {.041, .026, .036}, 2}},
      {"hammer", {60, 90, {.28, .109, .027}, {.29, .111, .029}, 2}},
      {"screwdriver", {120, 180, {.2, .028, .028}, {.204, .03, .03}}},
      {"kitchen_unit", {1400, 2500, {1.23, .6, 1.29}, {1.25, .62, 1.31}, 41}},
      {"cutlery_drawer", {300, 900, {.59, .5, .14}, {.6, .53, .16}, 11}},
      {"drawer_shallow", {150, 600, {.59, .5, .23}, {.6, .53, .25}, 6}},
      {"drawer_deep", {150, 600, {.59, .5, .36}, {.6, .53, .37}, 6}},
      {"door_left", {80, 350, {.29, .04, .76}, {.3, .06, .77}, 2}},
      {"door_right", {80, 350, {.29, .04, .76}, {.3, .06, .77}, 2}},
      {"chopping_board", {60, 300, {.35, .23, .017}, {.37, .25, .019}}},
      {"toolbox", {48, 48, {.39, .17, .21}, {.41, .19, .22}, 4}},
  };
  return table;
}

int num_shared(const Index3& a, const Index3& b) {
  int n = 0;
  for (const Index i : a)
    for (const Index j : b) n += i == j;
  return n;
}

/// The edge of face f opposite the corner that it shares with face g, as a flat triangle.
Triangle opposite_edge(const Mesh& mesh, Index f, Index g) {
  for (int c = 0; c < 3; ++c) {
    const Index3& t = mesh.triangles[f];
    const Vec3 &p = mesh.vertices[t[(c + 1) % 3]], &q = mesh.vertices[t[(c + 2) % 3]];
    for (const Index v : mesh.triangles[g])
      if (v == t[c]) return {p, q, q};
  }
  return mesh.triangle(f);
}

/// True if two faces meet anywhere but in their shared corners; exact, except for faces that share
/// an edge: there, only a fold back onto each other counts.
bool faces_cross(const Mesh& mesh, Index f, Index g) {
  const Triangle a = mesh.triangle(f), b = mesh.triangle(g);
  switch (num_shared(mesh.triangles[f], mesh.triangles[g])) {
    case 0:
      return triangles_intersect(a, b);
    case 1:
      return triangles_intersect(opposite_edge(mesh, f, g), b) ||
             triangles_intersect(opposite_edge(mesh, g, f), a);
    default: {
      const Vec3 n = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
      return n.dot((b[1] - b[0]).cross(b[2] - b[0]).normalized()) < -0.999;
    }
  }
}

std::vector<std::pair<Index, Index>> crossing_faces(const Mesh& mesh) {
  const auto num = static_cast<Index>(mesh.triangles.size());
  std::vector<Aabb> boxes(num);
  for (Index f = 0; f < num; ++f)
    for (const Vec3& p : mesh.triangle(f)) boxes[f].extend(p);
  std::vector<std::pair<Index, Index>> out;
  for (Index f = 0; f < num; ++f)
    for (Index g = f + 1; g < num; ++g)
      if (overlaps(boxes[f], boxes[g]) && faces_cross(mesh, f, g)) out.emplace_back(f, g);
  return out;
}

class Models : public ::testing::TestWithParam<std::string> {
 protected:
  Model m_model = make_model(GetParam());
  Adjacency m_adjacency = make_adjacency(m_model.mesh);
  const Expected& m_expected = expectations().at(GetParam());
};

TEST_P(Models, AreClosedAndConsistentlyOriented) {
  EXPECT_EQ(static_cast<int>(m_adjacency.components.size()), m_expected.num_components);
  for (const Component& c : m_adjacency.components) EXPECT_TRUE(c.manifold);
  std::vector<std::vector<Triangle>> parts(m_adjacency.components.size());
  for (size_t f = 0; f < m_model.mesh.triangles.size(); ++f)
    parts[m_adjacency.face_component[f]].push_back(m_model.mesh.triangle(static_cast<Index>(f)));
  for (const auto& part : parts) EXPECT_GT(signed_volume(part), 0);
  EXPECT_EQ(mass_properties(m_model.mesh, m_adjacency).rule, MassRule::Volume);
}

TEST_P(Models, HaveExpectedSize) {
  const int num = static_cast<int>(m_model.mesh.triangles.size());
  EXPECT_GE(num, m_expected.min_triangles);
  EXPECT_LE(num, m_expected.max_triangles);
  const Aabb box = m_model.mesh.box();
  const Vec3 size = box.upper - box.lower;
  EXPECT_TRUE((size.array() >= m_expected.min_size.array()).all()) << size.transpose();
  EXPECT_TRUE((size.array() <= m_expected.max_size.array()).all()) << size.transpose();
  EXPECT_EQ(box.lower.z(), 0);
}

TEST_P(Models, AreOnGrid) {
  for (const Vec3& p : m_model.mesh.vertices)
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(p[i], std::nearbyint(p[i] / kGrid) * kGrid);
      EXPECT_EQ(p[i], static_cast<double>(static_cast<float>(p[i])));
    }
}

TEST_P(Models, DoNotCrossThemselves) {
  const Adjacency& adjacency = m_adjacency;
  for (const auto& [f, g] : crossing_faces(m_model.mesh))
    EXPECT_NE(adjacency.face_component[f], adjacency.face_component[g])
        << "faces " << f << " and " << g << " near " << m_model.mesh.triangle(f)[0].transpose();
}

TEST_P(Models, HaveAppearance) {
  ASSERT_EQ(m_model.face_material.size(), m_model.mesh.triangles.size());
  ASSERT_EQ(m_model.corner_normals.size(), m_model.mesh.triangles.size());
  for (size_t f = 0; f < m_model.mesh.triangles.size(); ++f) {
    EXPECT_GE(m_model.face_material[f], 0);
    EXPECT_LT(m_model.face_material[f], static_cast<Index>(m_model.materials.size()));
    const Triangle t = m_model.mesh.triangle(static_cast<Index>(f));
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    EXPECT_GT(n.norm(), 1e-12) << "face " << f;
    for (const Eigen::Vector3f& c : m_model.corner_normals[f]) {
      EXPECT_NEAR(c.norm(), 1, 1e-5);
      EXPECT_GT(c.cast<double>().dot(n), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Models, ::testing::ValuesIn(model_names()),
                         [](const auto& made) { return made.param; });

TEST(Models, ListTheirNames) {
  EXPECT_EQ(model_names().size(), expectations().size());
  EXPECT_THROW(make_model("samovar"), Error);
}

// At the joint with a handle, a spout or a stem, the body meets only faces that look outwards: it
// ends within the wall.
TEST(Models, EndHandlesWithinWall) {
  for (const char* name : {"cup", "teapot", "jug", "mug"}) {
    const Model model = make_model(name);
    const Adjacency adjacency = make_adjacency(model.mesh);
    int num_met = 0;
    for (const auto& [f, g] : crossing_faces(model.mesh)) {
      ASSERT_EQ(adjacency.face_component[f], 0);
      const Triangle t = model.mesh.triangle(f);
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3, n = (t[1] - t[0]).cross(t[2] - t[0]);
      EXPECT_GT(n.x() * middle.x() + n.y() * middle.y(), 0) << name << " face " << f;
      ++num_met;
    }
    EXPECT_GT(num_met, 20) << name;
  }
}

// Standing models have a flat base: several vertices at exactly z = 0, around the centre of mass.
TEST(Models, StandOnFlatBases) {
  for (const char* name :
       {"saucer", "plate",     "cup",  "glass", "bowl",         "egg_cup", "teapot",  "jug",
        "apple",  "toast",     "loaf", "desk",  "bookcase",     "chair",   "monitor", "keyboard",
        "mouse",  "telephone", "lamp", "mug",   "waste_basket", "plant",   "letter",  "report"}) {
    const Model model = make_model(name);
    const Vec3 centre = mass_properties(model.mesh, make_adjacency(model.mesh)).centre;
    Aabb base;
    int num = 0;
    for (const Vec3& p : model.mesh.vertices)
      if (p.z() == 0) base.extend(p), ++num;
    EXPECT_GE(num, 4) << name;
    EXPECT_GT((base.upper - centre).head<2>().minCoeff(), 0.008) << name;
    EXPECT_GT((centre - base.lower).head<2>().minCoeff(), 0.008) << name;
  }
}

TEST(Models, FitCupInSaucerWell) {
  double foot = 0, well = kInfinity;
  const Model cup = make_cup(), saucer = make_saucer();
  for (const Vec3& p : cup.mesh.vertices)
    if (p.z() == 0) foot = std::max(foot, p.head<2>().norm());
  for (const Vec3& p : saucer.mesh.vertices)
    if (p.z() > 0.0046 && p.head<2>().norm() > 0.02) well = std::min(well, p.head<2>().norm());
  EXPECT_GT(well, foot + 0.004);
}

TEST(Models, HaveFlatTableTopAndCloth) {
  const Model table = make_table();
  EXPECT_NEAR(table.mesh.box().upper.z(), kClothHeight, kGrid);
  int num_on_cloth = 0;
  for (const Vec3& p : table.mesh.vertices) num_on_cloth += p.z() == table.mesh.box().upper.z();
  EXPECT_GT(num_on_cloth, 20);
}

// Objects are put down at these heights: vertices there, and none above them.
TEST(Models, HaveFlatDeskTopAndBoards) {
  EXPECT_NEAR(make_desk().mesh.box().upper.z(), kDeskHeight, kGrid);
  const Model bookcase = make_bookcase();
  EXPECT_NEAR(bookcase.mesh.box().upper.z(), kBookcaseHeight, kGrid);
  for (const double board : kBookcaseBoards) {
    int num_on_board = 0, num_above = 0;
    for (const Vec3& p : bookcase.mesh.vertices) {
      num_on_board += std::abs(p.z() - board) < kGrid;
      num_above +=
          std::abs(p.x()) < 0.33 && p.y() < 0.15 && p.z() > board + kGrid && p.z() < board + 0.32;
    }
    EXPECT_GE(num_on_board, 4) << board;
    EXPECT_EQ(num_above, 0) << board;
  }
  EXPECT_NEAR(make_workbench().mesh.box().upper.z(), kBenchHeight, kGrid);
  const Model shelf = make_shop_shelf();
  for (const double board : kShopBoards) {
    const auto is_on = [&](const Vec3& p) { return std::abs(p.z() - board) < kGrid; };
    const auto& all = shelf.mesh.vertices;
    EXPECT_GE(std::count_if(all.begin(), all.end(), is_on), 4) << board;
  }
}

TEST(Models, FitPencilsInMug) {
  double inside = kInfinity;
  for (const Vec3& p : make_mug().mesh.vertices)
    if (p.z() > 0.011) inside = std::min(inside, p.head<2>().norm());
  const Vec3 pencil = make_pencil().mesh.box().upper - make_pencil().mesh.box().lower;
  EXPECT_GT(inside, 4 * pencil.y());
  EXPECT_GT(pencil.x(), 1.5 * make_mug().mesh.box().upper.z());
}

}  // namespace
}  // namespace trivet::shapes
