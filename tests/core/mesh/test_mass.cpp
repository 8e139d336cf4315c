#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/made_meshes.h"
#include "core/mesh/mass.h"
#include "core/mesh/part_masses.h"

namespace trivet {
namespace {

using namespace trivet::testing;

MassProperties mass_of(const Triangles& triangles) {
  const Mesh mesh = weld(triangles);
  return mass_properties(mesh, make_adjacency(mesh));
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

TEST(Mass, IntegratesCube) {
  const MassProperties mass = mass_of(make_cube());
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_STREQ(to_string(mass.rule), "volume");
  expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
  EXPECT_NEAR(mass.volume, 1, 1e-15);
  EXPECT_NEAR(mass.area, 6, 1e-14);
  EXPECT_NEAR(mass.radius_squared, 0.25, 1e-15);
}

TEST(Mass, IgnoresOrientationOfCube) {
  const MassProperties mass = mass_of(inside_out(make_cube()));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
  EXPECT_NEAR(mass.volume, 1, 1e-15);
  EXPECT_NEAR(mass.radius_squared, 0.25, 1e-15);
}

TEST(Mass, IntegratesTetrahedronFarFromOrigin) {
  const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  for (const double offset : {0.0, 1e2, 1e4, 1e6}) {
    const Vec3 by(offset, -offset, 2 * offset);
    const MassProperties mass =
        mass_of(moved(make_tetrahedron(corners[0], corners[1], corners[2], corners[3]), by));
    EXPECT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, 1.0 / 6, 1e-15);
    expect_near(mass.centre - by, Vec3::Constant(0.25), 1e-15 + 1e-15 * offset);
    double squares = 0;  // of the distances of the corners from the centre
    for (const Vec3& p : corners) squares += (p - Vec3::Constant(0.25)).squaredNorm();
    EXPECT_NEAR(mass.radius_squared, squares / 20, 1e-15);
  }
}

TEST(Mass, IntegratesSphere) {
  const double pi = 3.14159265358979323846;
  const Vec3 centre(10, 20, 30);
  const MassProperties mass = mass_of(moved(make_sphere(2, 6), centre));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  expect_near(mass.centre, centre, 1e-13);
  EXPECT_NEAR(mass.volume, 4.0 / 3 * pi * 8, 1e-3 * 4.0 / 3 * pi * 8);
  EXPECT_NEAR(mass.area, 4 * pi * 4, 1e-3 * 4 * pi * 4);
  EXPECT_NEAR(mass.radius_squared, 0.6 * 4, 1e-3 * 0.6 * 4);
}

void expect_near(const Mat3& a, const Mat3& b, double tolerance) {
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance) << a << "\nis not\n" << b;
}

Triangles turned(Triangles triangles, const Mat3& by) {
  for (Triangle& t : triangles)
    for (Vec3& p : t) p = by * p;
  return triangles;
}

const Mat3 kSomeRotation =
    (Eigen::AngleAxisd(0.7, Vec3::UnitZ()) * Eigen::AngleAxisd(-1.9, Vec3(1, 2, 2) / 3))
        .toRotationMatrix();

TEST(Covariance, IntegratesBox) {
  const Vec3 size(3, 0.5, 0.25);
  const Mat3 expected = (size.cwiseProduct(size) / 12).asDiagonal();
  const MassProperties mass = mass_of(make_box(Vec3::Zero(), size));
  expect_near(mass.covariance, expected, 1e-15);
  const Vec3 inertia(0.25 + 0.0625, 9 + 0.0625, 9 + 0.25);  // of a mass of 12
  expect_near(inertia_per_mass(mass.covariance), Mat3((inertia / 12).asDiagonal()), 2e-15);
}

TEST(Covariance, IntegratesMovedAndTurnedBox) {
  const Vec3 size(3, 0.5, 0.25), by(40, -7, 11);
  const Mat3 diagonal = (size.cwiseProduct(size) / 12).asDiagonal();
  const Triangles box = make_box(-size / 2, size / 2);
  for (const Triangles& triangles : {box, inside_out(box)}) {
    const MassProperties mass = mass_of(moved(turned(triangles, kSomeRotation), by));
    EXPECT_EQ(mass.rule, MassRule::Volume);
    expect_near(mass.covariance, Mat3(kSomeRotation * diagonal * kSomeRotation.transpose()), 1e-13);
    EXPECT_NEAR(mass.covariance.trace(), mass.radius_squared, 1e-15);
    EXPECT_EQ(mass.covariance, mass.covariance.transpose());
  }
}

TEST(Covariance, IntegratesTetrahedra) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 100; ++i) {
    Mat3 edges;
    for (int k = 0; k < 9; ++k) edges(k / 3, k % 3) = coordinate(random);
    if (std::abs(edges.determinant()) < 0.02) continue;
    const Vec3 offset(10, coordinate(random), -20);
    const std::array<Vec3, 4> p{offset, offset + edges.col(0), offset + edges.col(1),
                                offset + edges.col(2)};
    const Vec3 centre = (p[0] + p[1] + p[2] + p[3]) / 4;
    Mat3 expected = Mat3::Zero();
    for (const Vec3& corner : p) expected += (corner - centre) * (corner - centre).transpose() / 20;
    const MassProperties mass = mass_of(make_tetrahedron(p[0], p[1], p[2], p[3]));
    EXPECT_EQ(mass.rule, MassRule::Volume);
    expect_near(mass.covariance, expected, 1e-12);
  }
}

TEST(Covariance, IntegratesSpheresAndEllipsoids) {
  const Mat3 stretch = Vec3(1, 2, 0.5).asDiagonal();
  const Triangles sphere = make_sphere(2, 6);
  expect_near(mass_of(moved(sphere, {5, 5, 5})).covariance, Mat3(Mat3::Identity() * 4 / 5),
              1e-3 * 0.8);
  expect_near(mass_of(turned(sphere, stretch)).covariance, Mat3(stretch * stretch * 4 / 5), 4e-3);
}

TEST(Covariance, IntegratesSurface) {
  // A one-sided rectangle: no thickness, edges like a rod.
  Triangles sheet;
  add_quad(sheet, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
  const MassProperties mass = mass_of(moved(turned(sheet, kSomeRotation), {1, 2, 3}));
  EXPECT_EQ(mass.rule, MassRule::Surface);
  const Mat3 flat = (Vec3(4, 1, 0) / 12).asDiagonal();
  expect_near(mass.covariance, Mat3(kSomeRotation * flat * kSomeRotation.transpose()), 1e-14);
}

TEST(Mass, SubtractsCavityOfHollowSphere) {
  const MassProperties full = mass_of(make_sphere(1, 4));
  const Triangles outer = make_sphere(2, 4), inner = make_sphere(1, 4);
  const MassProperties hollow = mass_of(joined(outer, inside_out(inner)));
  EXPECT_EQ(hollow.rule, MassRule::Volume);
  expect_near(hollow.centre, Vec3::Zero(), 1e-14);
  EXPECT_NEAR(hollow.volume, 7 * full.volume, 1e-13);
  EXPECT_NEAR(hollow.area, 5 * full.area, 1e-12);
  EXPECT_NEAR(hollow.radius_squared, 31.0 / 7 * full.radius_squared, 1e-13);
}

TEST(Mass, SubtractsCavityOffCentre) {
  const Triangles cavity = inside_out(make_box(Vec3(0.5, 0.25, 0.25), Vec3(1, 0.75, 0.75)));
  const MassProperties mass = mass_of(joined(make_box(Vec3::Zero(), Vec3(2, 1, 1)), cavity));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 2 - 0.125, 1e-15);
  expect_near(mass.centre, Vec3((2 - 0.125 * 0.75) / 1.875, 0.5, 0.5), 1e-15);
}

// Inside out as a whole: the inner shell is the cavity, however both are wound.
TEST(Mass, TellsCavitiesByNesting) {
  const Triangles outer = make_sphere(2, 2), inner = make_sphere(1, 2);
  const double volume = mass_of(joined(outer, inside_out(inner))).volume;
  for (const Triangles& t : {joined(outer, inner), joined(inside_out(outer), inner),
                             joined(inside_out(outer), inside_out(inner))}) {
    const MassProperties mass = mass_of(t);
    EXPECT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, volume, 1e-12);
    expect_near(mass.centre, Vec3::Zero(), 1e-12);
    EXPECT_GT(mass.findings.num_turned_parts, 0);
  }
}

TEST(Mass, AddsTwoComponents) {
  const Triangles big = make_box(Vec3(10, 0, 0), Vec3(12, 2, 2));
  const MassProperties mass = mass_of(joined(make_cube(), big));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 9, 1e-13);
  expect_near(mass.centre, (Vec3::Constant(0.5) + 8 * Vec3(11, 1, 1)) / 9, 1e-13);
}

TEST(Mass, UsesSurfaceOfOpenBox) {
  Triangles triangles = make_cube();
  triangles.erase(triangles.begin(), triangles.begin() + 2);  // the top
  const MassProperties mass = mass_of(triangles);
  EXPECT_EQ(mass.rule, MassRule::Surface);
  EXPECT_STREQ(to_string(mass.rule), "surface");
  EXPECT_EQ(mass.volume, 0);
  EXPECT_NEAR(mass.area, 5, 1e-14);
  expect_near(mass.centre, Vec3(0.5, 0.5, 0.4), 1e-15);
  // About the cube's centre: each square 1/6 within its plane and 1/4 from it; then Steiner's
  // theorem.
  EXPECT_NEAR(mass.radius_squared, 1.0 / 6 + 0.25 - 0.01, 1e-15);
}

TEST(Mass, TurnsFlippedFaces) {
  for (const size_t count : {1u, 3u, 5u}) {
    Triangles triangles = make_cube();
    for (size_t f = 0; f < count; ++f) std::swap(triangles[2 * f][0], triangles[2 * f][1]);
    const MassProperties mass = mass_of(triangles);
    EXPECT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, 1, 1e-15);
    expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
    EXPECT_EQ(mass.findings.num_flipped_faces, static_cast<Index>(count));
  }
}

TEST(Mass, CountsDoubleFacesOnce) {
  Triangles one = make_cube(), turned = make_cube();
  one.push_back(one[0]);
  turned.push_back({turned[3][0], turned[3][2], turned[3][1]});
  for (const Triangles& t :
       {one, turned, joined(make_cube(), make_cube()), joined(make_cube(), inside_out(make_cube())),
        joined(make_cube(), joined(make_cube(), make_cube()))}) {
    const MassProperties mass = mass_of(t);
    EXPECT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, 1, 1e-15);
    expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
    EXPECT_EQ(mass.findings.num_double_faces, static_cast<Index>(t.size()) - 12);
  }
}

// Polygons that are there twice, cut along other diagonals: back to back, or from another corner.
TEST(Mass, CountsDoublePolygonsOnceHoweverTheyAreCut) {
  const auto prism = [](int corners, int first, bool turned) {
    std::vector<Vec3> base, top;
    for (int i = 0; i < corners; ++i) {
      const int k = (i + first) % corners;
      const double angle = 2 * 3.14159265358979 * k / corners;
      base.push_back(Vec3(std::cos(angle), std::sin(angle), 0));
      top.push_back(base.back() + Vec3(0.25, 0, 1));
    }
    Triangles out;
    for (int i = 1; i + 1 < corners; ++i) {
      out.push_back({base[0], base[i + 1], base[i]});
      out.push_back({top[0], top[i], top[i + 1]});
    }
    for (int i = 0; i < corners; ++i) {
      const int j = (i + 1) % corners;
      if (first == 0)
        add_quad(out, base[i], base[j], top[j], top[i]);
      else
        add_quad(out, base[j], top[j], top[i], base[i]);
    }
    return turned ? inside_out(out) : out;
  };
  for (const int corners : {4, 5, 6, 9})
    for (const bool turned : {false, true}) {
      const Triangles one = prism(corners, 0, false);
      const MassProperties alone = mass_of(one);
      const MassProperties mass = mass_of(joined(one, prism(corners, 1, turned)));
      EXPECT_EQ(mass.rule, MassRule::Volume);
      EXPECT_NEAR(mass.volume, alone.volume, 1e-14);
      expect_near(mass.centre, alone.centre, 1e-14);
      EXPECT_EQ(mass.findings.num_double_faces, static_cast<Index>(one.size()));
    }
}

Triangles cubes_at(const std::vector<Vec3>& corners, size_t num_inside_out) {
  Triangles out;
  for (size_t i = 0; i < corners.size(); ++i) {
    Triangles cube = make_cube();
    for (Triangle& t : cube)
      for (Vec3& p : t) p += corners[i];
    out = joined(out, i < num_inside_out ? inside_out(cube) : cube);
  }
  return out;
}

// Bricks and voxels that share corners have walls in between that are there twice.
TEST(Mass, LeavesOutWallsBetweenSolidsSideBySide) {
  struct Case {
    std::vector<Vec3> cubes;
    Index walls;
    bool has_edges_of_four;  // which only faces wound alike get across
  };
  for (const Case& c : {Case{{{0, 0, 0}, {0, 0, 1}}, 1, false},
                        {{{0, 0, 0}, {1, 0, 0}}, 1, false},
                        {{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, 2, false},
                        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 4, false},
                        {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, 2, false},
                        {{{0, 0, 0}, {0, 0, 1}, {1, 1, 1}}, 1, true}})
    for (size_t turned = 0; turned < (c.has_edges_of_four ? 1u : 2u); ++turned) {
      const MassProperties mass = mass_of(cubes_at(c.cubes, turned));
      Vec3 centre = Vec3::Constant(0.5);
      for (const Vec3& p : c.cubes) centre += p / static_cast<double>(c.cubes.size());
      EXPECT_EQ(mass.rule, MassRule::Volume);
      EXPECT_NEAR(mass.volume, static_cast<double>(c.cubes.size()), 1e-14);
      expect_near(mass.centre, centre, 1e-14);
      EXPECT_EQ(mass.findings.num_double_faces, 4 * c.walls);
      EXPECT_EQ(mass.findings.num_open_parts, 0);
    }
}

// Domes over the same outline are no polygon twice.
TEST(Mass, KeepsPatchesThatAreNotFlat) {
  const Vec3 o[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Triangles lenses;
  for (const double height : {1.0, 0.5})
    for (int i = 0; i < 4; ++i) {
      lenses.push_back({o[i], o[(i + 1) % 4], Vec3(0.5, 0.5, height)});
      lenses.push_back({o[(i + 1) % 4], o[i], Vec3(0.5, 0.5, -height)});
    }
  const MassProperties mass = mass_of(lenses);
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 1, 1e-14);
  EXPECT_EQ(mass.findings.num_double_faces, 0);
}

// Boxes side by side, at an angle to the axes, each inside out or not; some with a cavity.
TEST(Mass, OrientsEachPartByItself) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (unsigned bits = 0; bits < 64; ++bits) {
    Triangles all;
    Vec3 moment = Vec3::Zero();
    double volume = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 lower(3.0 * i, 0.1 * i, 0), upper = lower + Vec3(1 + i, 1, 2);
      const Vec3 in = lower + Vec3(0.25, 0.25, 0.5), out = in + Vec3(0.5, 0.25, 0.5);
      const bool hollow = i < 2;
      const Triangles box = make_box(lower, upper), cavity = make_box(in, out);
      all = joined(all, bits >> i & 1 ? inside_out(box) : box);
      if (hollow) all = joined(all, bits >> (3 + i) & 1 ? inside_out(cavity) : cavity);
      const double solid = 2.0 * (1 + i), empty = hollow ? 0.0625 : 0;
      volume += solid - empty;
      moment += solid * (lower + upper) / 2 - empty * (in + out) / 2;
    }
    for (Triangle& t : all)
      for (Vec3& p : t) p = turn * p;
    const MassProperties mass = mass_of(all);
    ASSERT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, volume, 1e-12);
    expect_near(mass.centre, turn * Vec3(moment / volume), 1e-12);
  }
}

// A box in a cavity in a box, as many times as there is room.
TEST(Mass, NestsDeeply) {
  Triangles all;
  double volume = 0;
  for (int depth = 0; depth < 7; ++depth) {
    const double half = 1 - 0.1 * depth;
    all = joined(all, make_box(Vec3::Constant(-half), Vec3::Constant(half)));
    volume += (depth % 2 ? -1 : 1) * 8 * half * half * half;
  }
  const MassProperties mass = mass_of(all);
  EXPECT_NEAR(mass.volume, volume, 1e-12);
  EXPECT_EQ(mass.findings.num_turned_parts, 3);
  const Mesh mesh = weld(all);
  const auto parts = part_masses(mesh, make_adjacency(mesh));
  ASSERT_EQ(parts.size(), 7u);
  for (size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].is_cavity, i % 2 == 1);
    EXPECT_EQ(parts[i].is_turned, i % 2 == 1);
    EXPECT_EQ(parts[i].num_triangles, 12);
  }
}

TEST(Mass, LeavesPartsThatPassThroughEachOtherAlone) {
  const Triangles leg = make_box(Vec3(0.2, 0.2, -3), Vec3(0.4, 0.4, 0.5));
  const MassProperties mass = mass_of(joined(make_cube(), leg));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 1 + 0.14, 1e-14);
  EXPECT_EQ(mass.findings.num_turned_parts, 0);
}

// A label on a box weighs nothing; a box within an open shell is not all there is.
TEST(Mass, NotesOpenPartsBesideClosedOnes) {
  Triangles label;
  add_quad(label, Vec3(0, 0, 1.01), Vec3(0.5, 0, 1.01), Vec3(0.5, 0.5, 1.01), Vec3(0, 0.5, 1.01));
  const MassProperties box = mass_of(joined(make_cube(), label));
  EXPECT_EQ(box.rule, MassRule::Volume);
  expect_near(box.centre, Vec3::Constant(0.5), 1e-15);
  EXPECT_EQ(box.findings.num_open_parts, 1);
  EXPECT_GT(box.findings.other_centre_distance, 0.01);
  EXPECT_EQ(mass_notes(box).size(), 2u);
  Triangles shell = make_box(Vec3::Constant(-2), Vec3::Constant(3));
  shell.erase(shell.begin(), shell.begin() + 2);
  const MassProperties open = mass_of(joined(make_cube(), shell));
  EXPECT_EQ(open.rule, MassRule::Surface);
  EXPECT_EQ(open.findings.num_open_parts, 1);
  EXPECT_TRUE(mass_notes(mass_of(make_cube())).empty());
}

TEST(Mass, UsesSurfaceForFanOfFaces) {
  Triangles triangles;
  for (int i = 0; i < 6; ++i)
    triangles.push_back({Vec3(0, 0, 0), Vec3(0, 0, 3), Vec3(i - 2.5, 1, 0)});
  const MassProperties mass = mass_of(triangles);
  EXPECT_EQ(mass.rule, MassRule::Surface);
  EXPECT_NEAR(mass.centre.z(), 1, 1e-15);
  EXPECT_NEAR(mass.centre.x(), 0, 1e-15);
}

TEST(Mass, IgnoresDegenerateFaces) {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  const MassProperties mass = mass_of(joined(make_cube(), {{a, a, b}, {a, a, a}, {b, a, b}}));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, 1, 1e-15);
  expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
}

TEST(Mass, UsesSurfaceForTwoSidedSheet) {
  Triangles sheet;
  add_quad(sheet, Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0.3), Vec3(0, 1, 0.3));
  const MassProperties mass = mass_of(joined(sheet, inside_out(sheet)));
  EXPECT_EQ(mass.rule, MassRule::Surface);
  expect_near(mass.centre, Vec3(0.5, 0.5, 0.15), 1e-15);
}

TEST(Mass, UsesHullWithoutArea) {
  Triangles triangles;  // the edges of a cube, as faces with two equal corners
  for (const Triangle& t : make_cube()) triangles.push_back({t[0], t[0], t[1]});
  for (const Triangle& t : make_cube()) triangles.push_back({t[1], t[2], t[2]});
  const MassProperties mass = mass_of(triangles);
  EXPECT_EQ(mass.rule, MassRule::Hull);
  EXPECT_STREQ(to_string(mass.rule), "hull");
  EXPECT_EQ(mass.area, 0);
  EXPECT_NEAR(mass.volume, 1, 1e-14);
  expect_near(mass.centre, Vec3::Constant(0.5), 1e-15);
  EXPECT_NEAR(mass.radius_squared, 0.25, 1e-14);
}

TEST(Mass, UsesVerticesOfNeedle) {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(1, 0, 0);
  const MassProperties mass = mass_of({{a, b, c}});
  EXPECT_EQ(mass.rule, MassRule::Hull);
  EXPECT_EQ(mass.volume, 0);
  expect_near(mass.centre, Vec3(5.0 / 3, 0, 0), 1e-15);
  EXPECT_NEAR(mass.radius_squared, 26.0 / 9, 1e-14);
}

TEST(Mass, HandlesPointAndEmptyMesh) {
  const Vec3 p(1, 2, 3);
  const MassProperties point = mass_of({{p, p, p}});
  EXPECT_EQ(point.rule, MassRule::Hull);
  EXPECT_EQ(point.centre, p);
  EXPECT_EQ(point.radius_squared, 0);
  const MassProperties nothing = mass_of({});
  EXPECT_EQ(nothing.rule, MassRule::Hull);
  EXPECT_EQ(nothing.centre, Vec3::Zero());
}

TEST(Mass, ScalesWithUnit) {
  for (const double unit : {1e-30, 1e-10, 1e10, 1e30}) {
    const MassProperties mass = mass_of(scaled(make_cube(), unit));
    EXPECT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.centre.x() / unit, 0.5, 1e-14);
    EXPECT_NEAR(mass.radius_squared / (unit * unit), 0.25, 1e-14);
  }
}

/// Random affine images of the cube: the centre moves along, and the spread follows the covariance.
TEST(Mass, FollowsAffineMaps) {
  constexpr unsigned kSeed = 3;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const Mat3 linear = Mat3::NullaryExpr([&] { return number(random); });
    const Vec3 by = Vec3::NullaryExpr([&] { return 100 * number(random); });
    Triangles triangles = make_cube();
    for (Triangle& t : triangles)
      for (Vec3& p : t) p = linear * p + by;
    const double determinant = linear.determinant();
    if (std::abs(determinant) < 1e-3) continue;
    const MassProperties mass = mass_of(triangles);
    ASSERT_EQ(mass.rule, MassRule::Volume);
    EXPECT_NEAR(mass.volume, std::abs(determinant), 1e-12);
    expect_near(mass.centre, linear * Vec3::Constant(0.5) + by, 1e-11);
    EXPECT_NEAR(mass.radius_squared, linear.squaredNorm() / 12, 1e-11);
  }
}

TEST(Mass, StaysFiniteAndInBoxForTangles) {
  constexpr unsigned kSeed = 4;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (int round = 0; round < 300; ++round) {
    const Mesh mesh = weld(make_tangle(random, 1 + static_cast<int>(random() % 30),
                                       1 + static_cast<int>(random() % 12)));
    const MassProperties mass = mass_properties(mesh, make_adjacency(mesh));
    const Aabb box = mesh.box();
    EXPECT_TRUE(std::isfinite(mass.radius_squared));
    EXPECT_EQ(mass.radius_squared > 0, box.diagonal() > 0);
    EXPECT_TRUE(
        ((mass.centre - box.centre()).cwiseAbs().array() <= box.half_extent().array() + 1e-12)
            .all());
  }
}

}  // namespace
}  // namespace trivet
