// Compares faces on lines of sight with every line cut with every face.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <tuple>

#include "raster/zlist/line_faces.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

using Met = std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, float>;

// Column, row, depth; all in pixels.
Vec3 in_pixels(const Vec3& p, const Projection& view) {
  return Vec3(view.right.dot(p) - view.corner.x(), view.up.dot(p) - view.corner.y(),
              view.direction.dot(p) - view.nearest) /
         view.pixel;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Pixels by which a point lies inside of the face's sides; negative: outside of one.
double inside(const Triangle& t, const Vec2& at) {
  const double sign = cross((t[1] - t[0]).head<2>(), (t[2] - t[0]).head<2>()) < 0 ? -1 : 1;
  double out = kInfinity;
  for (int k = 0; k < 3; ++k) {
    const Vec2 side = (t[(k + 1) % 3] - t[k]).head<2>();
    out = std::min(out, sign * cross(side, at - t[k].head<2>()) / side.norm());
  }
  return out;
}

struct LineCounts {
  int met = 0, missed = 0, wrong = 0;
};

void compare(const Met& met, const Projection& view, const Triangle& world, std::uint32_t body,
             std::uint32_t face, LineCounts& counts) {
  Triangle t;
  for (int k = 0; k < 3; ++k) t[k] = in_pixels(world[k], view);
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double slope = normal.head<2>().norm() / std::abs(normal.z());
  if (!(slope < 3)) return;  // seen edge-on its depth is not sure, so that it may be left out
  for (int pixel = 0; pixel < view.width * view.height; ++pixel) {
    const int column = pixel % view.width, row = pixel / view.width;
    const Vec2 at(column + 0.5, row + 0.5);
    const auto found = met.find({static_cast<std::uint32_t>(pixel), body, face});
    const double in = inside(t, at);
    if (found == met.end()) {
      counts.wrong += in > 0.03;
      ++counts.missed;
      continue;
    }
    const double depth = t[0].z() - normal.head<2>().dot(at - t[0].head<2>()) / normal.z();
    counts.wrong += in < 0 || std::abs(depth - found->second) > 0.03;
    ++counts.met;
  }
}

TEST(LineFaces, AreThoseThatTheLinesMeet) {
  test::Random random(12);
  LineCounts counts;
  const int num = test::with_effort(400);
  for (int i = 0; i < num; ++i) {
    const auto ball = test::shape_of(test::bumpy_sphere(5, 8, 0.3, static_cast<unsigned>(i)));
    const auto soup = test::shape_of(test::soup(12, i % 5, random));
    std::vector<Body> bodies;
    for (const auto& shape : {ball, soup})
      bodies.emplace_back(*shape,
                          world_from_object({random.rotation(), random.in_cube(1)}, UpAxis::Z, 1));
    ProjectionOptions options;
    options.resolution = random.integer(1, 28);
    if (i % 2 == 1) options.direction = 3 * random.direction();
    if (i % 3 == 1) options.region = {Vec2(-0.4, -0.2), Vec2(0.3, 0.9)};
    const Projection view = projection_of(bodies, options);
    Met met;
    std::uint32_t last_body = 0;
    for_each_face_on_lines(bodies, view, [&](const FaceOnLine& f) {
      EXPECT_TRUE(met.insert({{f.pixel, f.body, f.face}, f.depth}).second) << "scene " << i;
      EXPECT_GE(f.body, last_body);
      last_body = f.body;
    });
    for (std::uint32_t b = 0; b < bodies.size(); ++b)
      for (Index f = 0; f < static_cast<Index>(bodies[b].shape->mesh.triangles.size()); ++f)
        compare(met, view, bodies[b].triangle(f), b, static_cast<std::uint32_t>(f), counts);
    ASSERT_EQ(counts.wrong, 0) << "scene " << i;
  }
  EXPECT_GT(counts.met, 30 * num);
  EXPECT_GT(counts.missed, counts.met);
}

// Faces of a pixel's size on a body that is thousands of pixels large.
TEST(LineFaces, AreMetOnBodiesFarLargerThanTheImage) {
  LineCounts counts;
  for (unsigned seed = 0; seed < 3; ++seed) {
    auto triangles = test::terrain(24, 0.03, 0.02, seed);
    triangles.push_back({Vec3(9, 9, 0), Vec3(10, 9, 0), Vec3(9, 10, 0)});
    triangles.push_back({Vec3(-9, -9, 0), Vec3(-10, -9, 0), Vec3(-9, -10, 0)});
    const auto shape = test::shape_of(triangles);
    const std::vector<Body> bodies{Body(*shape, world_from_object({}, UpAxis::Z, 1))};
    ProjectionOptions options;
    options.resolution = 28;
    options.region = {Vec2(-0.02, -0.02), Vec2(0.02, 0.02)};
    const Projection view = projection_of(bodies, options);
    Met met;
    for_each_face_on_lines(bodies, view, [&](const FaceOnLine& f) {
      met[{f.pixel, f.body, f.face}] = f.depth;
    });
    for (Index f = 0; f < static_cast<Index>(shape->mesh.triangles.size()); ++f)
      compare(met, view, bodies[0].triangle(f), 0, static_cast<std::uint32_t>(f), counts);
  }
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_GT(counts.met, 3 * 400);
}

TEST(LineFaces, AreNoneWithoutBodies) {
  int num = 0;
  for_each_face_on_lines({}, projection_of({}, {}), [&](const FaceOnLine&) { ++num; });
  EXPECT_EQ(num, 0);
}

}  // namespace
}  // namespace trivet
