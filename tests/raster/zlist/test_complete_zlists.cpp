// Compares complete z-lists with every triangle clipped to every pixel, and with rays.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "raster/zlist/complete_zlists.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

using Shapes = std::vector<std::shared_ptr<const Shape>>;

// Column, row, depth; pixels and metres.
Vec3 in_image(const Vec3& p, const Projection& view) {
  return {(view.right.dot(p) - view.corner.x()) / view.pixel,
          (view.up.dot(p) - view.corner.y()) / view.pixel, view.direction.dot(p)};
}

// The part of a polygon where sign * x[axis] <= limit.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double sign, double limit) {
  std::vector<Vec3> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double x = sign * a[axis] - limit, y = sign * b[axis] - limit;
    if (x <= 0) out.push_back(a);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) out.push_back(a + x / (x - y) * (b - a));
  }
  return out;
}

// The part of a triangle in a pixel grown by `grown` pixels.
std::vector<Vec3> in_pixel(const Triangle& t, int column, int row, double grown) {
  std::vector<Vec3> out(t.begin(), t.end());
  out = clipped(out, 0, 1, column + 1 + grown);
  out = clipped(out, 0, -1, grown - column);
  out = clipped(out, 1, 1, row + 1 + grown);
  return clipped(out, 1, -1, grown - row);
}

const ZListItem* find(std::span<const ZListItem> list, size_t body, Index face) {
  for (const ZListItem& item : list)
    if (item.body == body && item.face == static_cast<std::uint32_t>(face)) return &item;
  return nullptr;
}

struct ListCounts {
  int present = 0, absent = 0, wrong = 0, centres = 0, rays = 0;
};

// Compares one face with all pixels.
void compare(const CompleteZLists& lists, const Triangle& world, size_t body, Index face,
             ListCounts& counts) {
  const Projection& view = lists.projection();
  Triangle t;
  for (int k = 0; k < 3; ++k) t[k] = in_image(world[k], view);
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const ZListItem* item = find(lists.list(column, row), body, face);
      const std::vector<Vec3> part = in_pixel(t, column, row, -1e-9);
      counts.wrong += !part.empty() && !item;                          // missed
      counts.wrong += item && in_pixel(t, column, row, 0.03).empty();  // not even near
      (item ? counts.present : counts.absent)++;
      if (!item) continue;
      for (const Vec3& p : part)
        counts.wrong += !(view.depth(item->lower) <= p.z() && p.z() <= view.depth(item->upper));
      const auto [low, high] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
      const double slack = 1e-6 * (high - view.nearest);
      counts.wrong += view.depth(item->lower) < low - slack;
      counts.wrong += view.depth(item->upper) > high + slack;
      if (std::isnan(item->centre)) continue;
      ++counts.centres;
      const double centre = view.depth(item->centre);
      for (const Vec3& p : in_pixel(t, column, row, -0.4999))  // close to the line
        counts.wrong += std::abs(p.z() - centre) > 0.03 * view.pixel;
      counts.wrong += !(view.depth(item->lower) <= centre && centre <= view.depth(item->upper));
    }
}

TEST(CompleteZLists, ContainAllFacesOfEveryPixel) {
  test::Random random(8);
  ListCounts counts;
  const int num = test::with_effort(600);
  for (int i = 0; i < num; ++i) {
    Shapes shapes;
    std::vector<Body> bodies;
    for (int k = 0; k < 3; ++k) {
      shapes.push_back(test::shape_of(k == 0
                                          ? test::bumpy_sphere(4, 6, 0.3, static_cast<unsigned>(i))
                                      : k == 1 ? test::box_triangles(random.in_cube(0.5).cwiseAbs())
                                               : test::soup(12, i % 5, random)));
      const Rotation turn = i % 3 == 0 ? Rotation{} : random.rotation();  // includes edge-on faces
      bodies.emplace_back(*shapes.back(),
                          world_from_object({turn, random.in_cube(1)}, UpAxis::Z, 1));
    }
    ProjectionOptions options;
    options.resolution = random.integer(1, 24);
    if (i % 2 == 1) options.direction = 3 * random.direction();
    if (i % 5 == 1) options.region = {Vec2(-0.4, -0.2), Vec2(0.3, 0.9)};
    const CompleteZLists lists(bodies, options);
    for (size_t b = 0; b < bodies.size(); ++b)
      for (Index f = 0; f < static_cast<Index>(shapes[b]->mesh.triangles.size()); ++f)
        compare(lists, bodies[b].triangle(f), b, f, counts);
    ASSERT_EQ(counts.wrong, 0) << "scene " << i;
  }
  EXPECT_GT(counts.present, 300 * num);
  EXPECT_GT(counts.absent, counts.present);
  EXPECT_GT(counts.centres, counts.present / 10);
}

// A line through a solid enters and leaves alternately, equally often.
TEST(CompleteZLists, EnterAndLeaveSolids) {
  const auto sphere = test::shape_of(test::bumpy_sphere(12, 18, 0.3, 3));
  std::vector<Triangle> inside_out = test::box_triangles({0.5, 0.6, 0.7});
  for (Triangle& t : inside_out) std::swap(t[0], t[1]);
  const auto box = test::shape_of(inside_out);
  const auto sheet = test::shape_of({{Vec3(-1, -1, 3), Vec3(1, -1, 3), Vec3(0, 1, 3)}});
  const Rotation turn = Rotation{0.9, 0.2, -0.3, 0.1}.normalized();
  const std::vector<Body> bodies{{*sphere, {}},
                                 {*box, world_from_object({turn, Vec3(0.3, 0, -2)}, UpAxis::Z, 1)},
                                 {*sheet, {}}};
  ProjectionOptions options;
  options.resolution = 64;
  options.direction = Vec3(0.05, 0.02, -1);
  const CompleteZLists lists(bodies, options);
  int num_lines = 0, num_sheet = 0;
  for (int row = 0; row < lists.projection().height; ++row)
    for (int column = 0; column < lists.projection().width; ++column)
      for (const std::uint32_t body : {0u, 1u, 2u}) {
        std::vector<ZListItem> line;
        bool grazes = false;
        for (const ZListItem& item : lists.list(column, row)) {
          if (item.body != body) continue;
          line.push_back(item);
          grazes |= std::isnan(item.centre);
        }
        if (grazes || line.empty()) continue;
        std::sort(line.begin(), line.end(),
                  [](const ZListItem& a, const ZListItem& b) { return a.centre < b.centre; });
        if (body == 2) {
          ASSERT_EQ(lists.crossing(line[0]), Crossing::Unknown);
          ++num_sheet;
          continue;
        }
        ASSERT_EQ(line.size() % 2, 0u);
        for (size_t i = 0; i < line.size(); ++i)
          ASSERT_EQ(lists.crossing(line[i]), i % 2 == 0 ? Crossing::Enters : Crossing::Leaves);
        ++num_lines;
      }
  EXPECT_GT(num_lines, 500);
  EXPECT_GT(num_sheet, 100);
}

bool same(const CompleteZLists& a, const CompleteZLists& b) {
  if (a.num_entries() != b.num_entries()) return false;
  for (int row = 0; row < a.projection().height; ++row)
    for (int column = 0; column < a.projection().width; ++column) {
      const auto x = a.list(column, row), y = b.list(column, row);
      if (x.size() != y.size()) return false;
      for (size_t i = 0; i < x.size(); ++i)
        if (x[i].body != y[i].body || x[i].face != y[i].face || x[i].lower != y[i].lower ||
            x[i].upper != y[i].upper)
          return false;
    }
  return true;
}

TEST(CompleteZLists, AreTheSameWithAnyNumberOfThreads) {
  const auto sphere = test::shape_of(test::bumpy_sphere(200, 250, 0.2, 3));
  const std::vector<Body> bodies{{*sphere, {}},
                                 {*sphere, world_from_object({{}, Vec3(1, 0, 0.5)}, UpAxis::Z, 1)}};
  ProjectionOptions options;
  const CompleteZLists one(bodies, options);
  options.num_threads = 4;
  const CompleteZLists four(bodies, options);
  EXPECT_TRUE(same(one, four));
  EXPECT_GT(one.num_entries(), 200000u);
  EXPECT_GT(one.longest(), 4u);
  EXPECT_LT(one.num_covered(), size_t(one.projection().width) * one.projection().height);
}

TEST(CompleteZLists, AreEmptyWithoutBodies) {
  const CompleteZLists lists({}, {});
  EXPECT_EQ(lists.projection().width, 0);
  EXPECT_EQ(lists.num_entries(), 0u);
  EXPECT_EQ(lists.longest(), 0u);
}

void expect_refusal(const ProjectionOptions& options, const std::string& says) {
  const auto box = test::shape_of(test::box_triangles({1, 1, 1}));
  const std::vector<Body> bodies{{*box, {}}};
  try {
    const CompleteZLists lists(bodies, options);
    FAIL() << "accepted: " << says;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput);
    EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
  }
}

TEST(CompleteZLists, NameAcceptedOptions) {
  ProjectionOptions options;
  options.direction = Vec3::Zero();
  expect_refusal(options, "direction of z-lists is 0 0 0");
  options = {};
  options.direction.x() = std::nan("");
  expect_refusal(options, "direction");
  options = {};
  options.resolution = 8193;
  expect_refusal(options, "1 to 8192");
  options = {};
  options.region = {Vec2(0, 0), Vec2(1, 0)};
  expect_refusal(options, "above 0");
  options.region = {Vec2(0, 0), Vec2(1e-9, 1e-9)};
  expect_refusal(options, "region of z-lists has pixels of");
  options = {};
  options.most_bytes = 1 << 20;
  expect_refusal(options, "take fewer pixels");
  options.resolution = 1024;
  expect_refusal(options, "1024 x 1024 pixels need more than the 1 MiB");
}

}  // namespace
}  // namespace trivet
