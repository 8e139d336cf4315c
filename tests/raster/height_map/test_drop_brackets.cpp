// Brackets of falls: the correlation against plain loops, and the brackets against exact falls.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "raster/height_map/height_map.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr float kInf = static_cast<float>(kInfinity);

HeightMap random_map(int width, int height, float nothing, test::Random& random) {
  HeightMap map(width, height, nothing);
  for (size_t i = 0; i < map.bound.size(); ++i) {
    if (random.integer(0, 3) == 0) continue;
    map.bound[i] = static_cast<float>(random.uniform(-1, 1));
    if (random.integer(0, 3)) map.sample[i] = map.bound[i];
  }
  return map;
}

DropBracket by_loops(const HeightMap& object, const HeightMap& scene, int column, int row) {
  DropBracket out{kInf, kInf};
  for (int y = 0; y < object.height; ++y)
    for (int x = 0; x < object.width; ++x) {
      const size_t a = object.index(x, y), b = scene.index(x + column, y + row);
      out.lower = std::min(out.lower, object.bound[a] - scene.bound[b]);
      out.upper = std::min(out.upper, object.sample[a] - scene.sample[b]);
    }
  return out;
}

// Beyond the fall itself, a little less, a little more, and where it need not be known.
void expect_farther(const HeightMap& object, const HeightMap& scene, int columns, int rows,
                    const std::vector<DropBracket>& found, test::Random& random) {
  std::vector<float> falls(found.size());
  for (size_t i = 0; i < falls.size(); ++i) {
    const int kind = random.integer(0, 4);
    falls[i] = kind == 0   ? kInf
               : kind == 1 ? found[i].lower
               : kind == 2 ? std::nextafter(found[i].lower, -kInf)
                           : static_cast<float>(random.uniform(-1.5, 1.5));
  }
  const std::vector<char> farther = falls_farther(object, scene, columns, rows, falls);
  ASSERT_EQ(farther.size(), falls.size());
  for (size_t i = 0; i < falls.size(); ++i)
    ASSERT_EQ(farther[i], char{falls[i] < kInf && found[i].lower > falls[i]}) << i;
}

// A round underside over a flat top with pits, holes and steps: most tiles cannot hold the minimum.
TEST(DropBrackets, EqualPlainLoopsOverFlatScenes) {
  test::Random random(12);
  for (const int width : {5, 16, 41}) {
    const int columns = 37, rows = 21;
    HeightMap object(width, width, kInf), scene(columns + width, rows + width, -kInf);
    for (int y = 0; y < width; ++y)
      for (int x = 0; x < width; ++x) {
        const float a = 2.0F * x / width - 1, b = 2.0F * y / width - 1, r = a * a + b * b;
        if (r < 1) object.bound[object.index(x, y)] = object.sample[object.index(x, y)] = 0.3F * r;
      }
    for (int y = 0; y < scene.height; ++y)
      for (int x = 0; x < scene.width / 2 + y; ++x) {
        const bool pit = random.integer(0, 40) == 0;
        const size_t at = scene.index(std::min(x, scene.width - 1), y);
        scene.bound[at] = pit ? random.integer(0, 1) ? -kInf : -1 : y < 9 ? 0.1F : 0;
        scene.sample[at] = scene.bound[at] - 0.05F;
      }
    const auto found = drop_brackets(object, scene, columns, rows);
    expect_farther(object, scene, columns, rows, found, random);
    const DropProbe probe(object);
    for (int i = 0; i < columns * rows; ++i) {
      const DropBracket truth = by_loops(object, scene, i % columns, i / columns);
      ASSERT_EQ(found[i].lower, truth.lower) << i;
      ASSERT_EQ(found[i].upper, truth.upper) << i;
      const DropBracket single = probe.at(scene, i % columns, i / columns);
      ASSERT_EQ(single.lower, truth.lower) << i;
      ASSERT_EQ(single.upper, truth.upper) << i;
    }
  }
}

TEST(DropBrackets, EqualPlainLoopsAtOddSizes) {
  test::Random random(11);
  for (const int width : {1, 2, 7, 8, 9, 17, 40})
    for (const int height : {1, 3, 16}) {
      const int columns = random.integer(1, 20), rows = random.integer(1, 20);
      const HeightMap object = random_map(width, height, kInf, random);
      const HeightMap scene = random_map(columns + width - 1, rows + height + 2, -kInf, random);
      for (const size_t threads : {1, 2, 8}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const auto found = drop_brackets(object, scene, columns, rows);
        expect_farther(object, scene, columns, rows, found, random);
        for (int i = 0; i < columns * rows; ++i) {
          const DropBracket truth = by_loops(object, scene, i % columns, i / columns);
          ASSERT_EQ(found[i].lower, truth.lower);
          ASSERT_EQ(found[i].upper, truth.upper);
        }
      }
    }
}

TEST(DropBrackets, NeedNoSamplesForLowerBounds) {
  test::Random random(13);
  HeightMap object = random_map(19, 11, kInf, random);
  const HeightMap scene = random_map(40, 30, -kInf, random);
  const auto both = drop_brackets(object, scene, 20, 18);
  std::fill(object.sample.begin(), object.sample.end(), kInf);
  const auto lower = drop_brackets(object, scene, 20, 18);
  ASSERT_EQ(lower.size(), both.size());
  for (size_t i = 0; i < both.size(); ++i) {
    ASSERT_EQ(lower[i].lower, both[i].lower);
    ASSERT_EQ(lower[i].upper, kInf);
  }
}

Mesh single_face(const Triangle& t) { return {{t[0], t[1], t[2]}, {{0, 1, 2}}}; }

// Faces that are hidden by others are left out: the maps are those of all faces, drawn one by one.
TEST(HeightMaps, AreThoseOfAllFacesDrawnAlone) {
  const test::MeshPool pool(17, 12);
  for (int i = 0; i < 24; ++i) {
    const test::RandomQuery q = test::random_query(pool, 17, i);
    Body body = q.moving[0].body();
    body.world_box = Aabb();
    for (size_t v = 0; v < body.shape->mesh.vertices.size(); ++v)
      body.world_box.extend(body.vertex(static_cast<Index>(v)));
    const double pixel = body.world_box.diagonal() / (3 + 5 * (i % 5));
    const MapGrid grid = MapGrid::about(body.world_box, pixel, body.world_box.lower.z());
    const HeightMap under = draw_underside({&body, 1}, grid, 1e-4 * pixel);
    const HeightMap top = draw_top({&body, 1}, grid, false, kInfinity);
    HeightMap alone_under(grid.width, grid.height, kInf), alone_top(grid.width, grid.height, -kInf);
    for (Index f = 0; f < static_cast<Index>(body.shape->mesh.triangles.size()); ++f) {
      const Triangle t = body.shape->mesh.triangle(f);
      const auto shape = make_shape(single_face(t));
      Body face = body;
      face.shape = shape.get();
      const HeightMap below = draw_underside({&face, 1}, grid, 1e-4 * pixel);
      const HeightMap above = draw_top({&face, 1}, grid, false, kInfinity);
      for (size_t at = 0; at < top.bound.size(); ++at) {
        alone_under.bound[at] = std::min(alone_under.bound[at], below.bound[at]);
        alone_under.sample[at] = std::min(alone_under.sample[at], below.sample[at]);
        alone_top.bound[at] = std::max(alone_top.bound[at], above.bound[at]);
        alone_top.sample[at] = std::max(alone_top.sample[at], above.sample[at]);
      }
    }
    ASSERT_EQ(under.bound, alone_under.bound) << i;
    ASSERT_EQ(under.sample, alone_under.sample) << i;
    ASSERT_EQ(top.bound, alone_top.bound) << i;
    ASSERT_EQ(top.sample, alone_top.sample) << i;
  }
}

// An object above a scene, and a grid of places for it.
struct Falls {
  Body object, scene;
  MapGrid grid;
  Vec2 first;
  double start_z;
  static constexpr int kPlaces = 12;

  Falls(const test::RandomQuery& q, double pixels_across) {
    object = q.moving[0].body();
    object.world_box = Aabb();
    for (size_t v = 0; v < q.moving[0].shape->mesh.vertices.size(); ++v)
      object.world_box.extend(object.vertex(static_cast<Index>(v)));
    scene = q.fixed[0].body();
    start_z = scene.world_box.upper.z() + 0.01;
    const double size = std::max(object.world_box.diagonal(), scene.world_box.diagonal());
    grid = MapGrid::about(object.world_box, size / pixels_across, object.world_box.lower.z());
    first = (scene.world_box.centre() - object.world_box.centre()).head<2>() -
            Vec2::Constant(0.5 * kPlaces * grid.pixel);
  }
  MapGrid scene_grid() const {
    MapGrid out = grid;
    out.corner += first;
    out.width += kPlaces - 1;
    out.height += kPlaces - 1;
    out.level = start_z;
    return out;
  }
  Body at(int column, int row) const {
    Body out = object;
    const Vec2 by = first + grid.pixel * Vec2(column, row);
    const Vec3 shift(by.x(), by.y(), start_z - object.world_box.lower.z());
    out.world_from_object.translation += shift;
    out.world_box.lower += shift;
    out.world_box.upper += shift;
    return out;
  }
};

TEST(DropBrackets, ContainExactFall) {
  constexpr unsigned kSeed = 31;
  const test::MeshPool pool(kSeed, 8);
  const int num_scenes = std::max(60, test::with_effort(60));  // for the shares below
  int num_places = 0, num_hits = 0, num_bracketed = 0;
  double width = 0;
  for (int i = 0; i < num_scenes; ++i) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Falls falls(q, i % 3 == 0 ? 16 : i % 3 == 1 ? 61 : 200);
    const double clearance = 1e-6 * falls.scene.world_box.diagonal();
    const HeightMap underside = draw_underside({&falls.object, 1}, falls.grid, 1.01 * clearance);
    const HeightMap top = draw_top({&falls.scene, 1}, falls.scene_grid(), false);
    const auto brackets = drop_brackets(underside, top, falls.kPlaces, falls.kPlaces);
    for (int k = 0; k < falls.kPlaces * falls.kPlaces; k += 5) {
      const Body body = falls.at(k % falls.kPlaces, k / falls.kPlaces);
      FirstContactQuery query;
      query.moving = {&body, 1};
      query.fixed = {&falls.scene, 1};
      query.motion = Motion::translation(-Vec3::UnitZ(), 100 * falls.scene.world_box.diagonal());
      query.clearance.distance = clearance;
      const double exact = first_contact(query).time;
      EXPECT_LE(brackets[k].lower, exact) << q.describe() << " place " << k;
      EXPECT_GE(brackets[k].upper, exact) << q.describe() << " place " << k;
      ++num_places;
      if (exact == kInfinity) continue;
      ++num_hits;
      if (brackets[k].upper == kInf) continue;
      ++num_bracketed;
      width += (brackets[k].upper - brackets[k].lower) / falls.grid.pixel;
    }
  }
  std::printf("%d places, %d falls end, %d have both bounds, mean width %.2f pixels\n", num_places,
              num_hits, num_bracketed, width / num_bracketed);
  EXPECT_GT(num_hits, 0.3 * num_places);
  EXPECT_GT(num_bracketed, 0.25 * num_hits);
  EXPECT_LT(width / num_bracketed, 20);
}

TEST(WidenedTop, IsMaximumWithinReach) {
  test::Random random(8);
  for (const double pixels : {0.0, 1.0, 1.5, 3.7, 9.2}) {
    for (const int border : {static_cast<int>(pixels), 12}) {
      HeightMap map(17 + 2 * border, 5 + 2 * border, -static_cast<float>(kInfinity));
      for (float& height : map.bound)
        if (random.uniform(0, 1) < 0.3) height = static_cast<float>(random.uniform(-1, 1));
      const HeightMap found = widened_top(map, pixels, border);
      ASSERT_EQ(found.width, 17);
      ASSERT_EQ(found.height, 5);
      for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 17; ++x) {
          float truth = -static_cast<float>(kInfinity);
          for (int j = 0; j < map.height; ++j)
            for (int i = 0; i < map.width; ++i) {
              const int dx = i - x - border, dy = j - y - border;
              if (dx * dx + dy * dy <= pixels * pixels)
                truth = std::max(truth, map.bound[map.index(i, j)]);
            }
          ASSERT_EQ(found.bound[found.index(x, y)], truth);
        }
    }
  }
}

}  // namespace
}  // namespace trivet
