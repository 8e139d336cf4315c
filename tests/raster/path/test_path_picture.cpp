// Pictures by rays: known brightness, shadows, mirrors, glass, and the same bytes again.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "raster/path/picture.h"
#include "raster/path/sampler.h"

namespace trivet {
namespace {

struct Boxes {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;
  std::vector<Index> face_material;
  std::vector<Material> materials;

  void add(const Vec3& lower, const Vec3& upper, const Material& material) {
    static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const auto first = static_cast<Index>(vertices.size());
    for (int i = 0; i < 8; ++i)
      vertices.push_back({i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                          i & 4 ? upper.z() : lower.z()});
    for (const auto& s : kSides) {
      triangles.push_back({first + s[0], first + s[1], first + s[2]});
      triangles.push_back({first + s[0], first + s[2], first + s[3]});
      for (int i = 0; i < 2; ++i) face_material.push_back(static_cast<Index>(materials.size()));
    }
    materials.push_back(material);
  }
  PictureMesh view() const {
    PictureMesh mesh;
    mesh.vertices = vertices, mesh.triangles = triangles;
    mesh.face_material = face_material, mesh.materials = materials;
    return mesh;
  }
};

Material material(float r, float g, float b, float alpha = 1) {
  Material m;
  m.base_colour = {r, g, b, alpha};
  return m;
}

PictureScene scene_of(const PictureMesh& mesh, const Vec3& at = Vec3::Zero()) {
  PictureObject object;
  object.mesh = &mesh;
  object.world_from_object.translation = at;
  return {{object}, true};
}

PictureOptions small(int samples = 16, int width = 96, int height = 72) {
  PictureOptions options;
  options.width = width, options.height = height, options.samples = samples;
  options.background = {1, 1, 1, 1};
  return options;
}

Camera looking(const Vec3& eye, const Vec3& target, double fov = 40) {
  Camera camera;
  camera.eye = eye, camera.target = target, camera.fov_deg = fov;
  return camera;
}

double grey(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return (p[0] + p[1] + p[2]) / 3.0;
}

// Mean colour of 5 x 5 pixels.
Vec3 colour(const Image& image, int x, int y) {
  Vec3 sum = Vec3::Zero();
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const std::uint8_t* p = image.pixel(x + dx, y + dy);
      sum += Vec3(p[0], p[1], p[2]);
    }
  return sum / 25;
}

double rmse(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    sum += (double(a.rgba[i]) - b.rgba[i]) * (double(a.rgba[i]) - b.rgba[i]);
  return std::sqrt(sum / double(a.rgba.size()));
}

// A cube on the floor, and a wall beside it.
Boxes room(const Material& cube, const Material& wall) {
  Boxes boxes;
  boxes.add(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1), cube);
  boxes.add(Vec3(1, -1, 0), Vec3(1.1, 1, 2), wall);
  return boxes;
}

Boxes grey_room() { return room(material(0.6f, 0.6f, 0.6f), material(0.6f, 0.6f, 0.6f)); }

TEST(PathPicture, OpenFloorHasItsKnownBrightness) {
  // Boxes of albedo 0.62, in the light that gives a radiance of 1 to a white floor.
  Boxes boxes;
  boxes.add(Vec3(-0.01, -0.01, 0), Vec3(0.01, 0.01, 0.001), material(0.6f, 0.6f, 0.6f));
  boxes.add(Vec3(3, 3, 0), Vec3(3.01, 3.01, 0.001), material(0.6f, 0.6f, 0.6f));
  const PictureMesh mesh = boxes.view();
  const Image image =
      trace_picture(scene_of(mesh), looking(Vec3(1.5, -2, 2), Vec3(1.5, 1.5, 0)), small(64));
  const double x = 1 - 0.4 * std::exp(-(0.62 - 0.6) / 0.4);
  const double srgb = 255 * (1.055 * std::pow(x, 1 / 2.4) - 0.055);
  EXPECT_NEAR(colour(image, 48, 36).mean(), srgb, 5);  // and some mirrored sky
}

TEST(PathPicture, ShadowIsDarkAndSoftAtItsEdge) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(32);
  const Camera camera = looking(Vec3(0, -5, 3), Vec3(0.5, 0, 0.5));
  const Image with = trace_picture(scene_of(mesh), camera, options);
  options.shadows = false;
  const Image without = trace_picture(scene_of(mesh), camera, options);
  int num_darker = 0, num_between = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      const double change = grey(without, x, y) - grey(with, x, y);
      num_darker += change > 40, num_between += change > 10 && change <= 40;
    }
  EXPECT_GT(num_darker, 100);
  EXPECT_GT(num_between, 30);
}

TEST(PathPicture, ColoursBleedWithBouncesOnly) {
  const Boxes boxes = room(material(0.7f, 0.7f, 0.7f), material(0.9f, 0.05f, 0.05f));
  const PictureMesh mesh = boxes.view();
  const Camera camera = looking(Vec3(0.8, -1.2, 1.5), Vec3(0.8, 0, 0), 60);
  const auto redness = [&](int bounces) {
    PathOptions path;
    path.bounces = bounces;
    const Image image = trace_picture(scene_of(mesh), camera, small(64), path);
    double most = -1e9;  // the floor between cube and wall is the only white thing that turns red
    for (int y = 4; y < 68; ++y)
      for (int x = 4; x < 92; ++x) {
        const Vec3 c = colour(image, std::clamp(x, 2, 93), std::clamp(y, 2, 69));
        if (c.y() > 90) most = std::max(most, c.x() - c.y());
      }
    return most;
  };
  EXPECT_GT(redness(3), redness(0) + 3);
}

TEST(PathPicture, MetalMirrorsItsNeighbour) {
  Material metal = material(0.95f, 0.95f, 0.95f);
  metal.metallic = 1, metal.roughness = 0.05f;
  Boxes boxes;
  boxes.add(Vec3(-1, 0.5, 0), Vec3(1, 0.6, 1), metal);
  boxes.add(Vec3(-1, -1.5, 0), Vec3(1, -1.4, 0.6), material(0.05f, 0.8f, 0.05f));
  const PictureMesh mesh = boxes.view();
  const Camera camera = looking(Vec3(0, -1.0, 0.5), Vec3(0, 0.5, 0.4), 40);
  const Vec3 seen = colour(trace_picture(scene_of(mesh), camera, small(32)), 48, 40);
  EXPECT_GT(seen.y(), seen.x() + 40);
}

TEST(PathPicture, GlassShowsWhatIsBehindAndLetsLightThrough) {
  Boxes boxes;
  Material glass = material(0.9f, 0.95f, 0.95f, 0.1f);
  glass.roughness = 0.05f;
  boxes.add(Vec3(-0.5, -0.5, 0), Vec3(0.5, -0.4, 1), glass);
  boxes.add(Vec3(-0.5, 0.4, 0), Vec3(0.5, 0.5, 1), material(0.05f, 0.1f, 0.9f));
  const PictureMesh mesh = boxes.view();
  const Camera camera = looking(Vec3(0, -3, 0.6), Vec3(0, 0, 0.5), 30);
  const Vec3 through = colour(trace_picture(scene_of(mesh), camera, small(32)), 48, 36);
  EXPECT_GT(through.z(), through.x() + 40);
  boxes.materials[0].base_colour[3] = 1;
  const PictureMesh opaque = boxes.view();
  const Vec3 hidden = colour(trace_picture(scene_of(opaque), camera, small(32)), 48, 36);
  EXPECT_LT(hidden.z(), hidden.x() + 40);
}

TEST(PathPicture, GlassShadowIsLighter) {
  Boxes boxes = grey_room();
  const Camera camera = looking(Vec3(0, -5, 3), Vec3(0.5, 0, 0.5));
  const auto brightness = [&] {
    const PictureMesh mesh = boxes.view();
    PictureScene scene = scene_of(mesh);
    const Image image = trace_picture(scene, camera, small(16));
    double sum = 0;
    for (int y = 36; y < 72; ++y)
      for (int x = 0; x < 96; ++x) sum += grey(image, x, y);
    return sum / (36 * 96);
  };
  const double opaque = brightness();
  for (Material& m : boxes.materials) m.base_colour = {1, 1, 1, 0.05f};
  EXPECT_GT(brightness(), opaque + 5);
}

// Radiance of a wall behind a slab of glass, and what the slab mirrors.
Vec3 seen_through(double thickness, const Glass& glass, float wall_albedo, bool floor) {
  Boxes boxes;
  boxes.add(Vec3(-2, -thickness, -1), Vec3(2, 0, 3), material(1, 1, 1));
  const auto look = std::make_shared<SurfaceLook>();
  look->materials = boxes.materials;
  look->materials[0].base_colour[3] = 1 - 0.9f * glass.share;
  look->finishes.resize(1);
  look->finishes[0].glass = glass;
  look->face_material = boxes.face_material;
  Boxes wall;
  wall.add(Vec3(-9, 0.5, -9), Vec3(9, 0.6, 9), material(wall_albedo, wall_albedo, wall_albedo));
  wall.materials[0].roughness = 1;
  PictureMesh slab = boxes.view();
  slab.look = [look](std::size_t) { return look; };
  const PictureMesh behind = wall.view();
  const PictureScene scene{{{&slab, {}, {}}, {&behind, {}, {}}}, floor};
  PictureOptions options = small(128, 16, 12);
  options.shadows = options.ambient_occlusion = false;  // the wall's light passes once
  const Image image = trace_picture(scene, looking(Vec3(0, -6, 1.2), Vec3(0, 0, 1), 10), options);
  const Vec3 srgb = colour(image, 8, 6) / 255;
  return srgb.unaryExpr([](double c) { return std::pow((c + 0.055) / 1.055, 2.4); });
}

// Share of the wall's light that comes through.
Vec3 passed(double thickness, const Glass& glass, bool floor) {
  Glass nearly_air;
  nearly_air.share = 1, nearly_air.index = 1.01f;
  nearly_air.absorbed_per_unit = {0, 0, 0};
  const auto light = [floor](double d, const Glass& g) {
    return Vec3(seen_through(d, g, 0.4f, floor) - seen_through(d, g, 0, floor));
  };
  return light(thickness, glass).cwiseQuotient(light(1e-3, nearly_air));
}

TEST(PathPicture, GlassAbsorbsByItsThickness) {
  Glass glass;
  glass.share = 1, glass.index = 1.01f;
  glass.absorbed_per_unit = {0, 2, 4};
  for (const double thickness : {0.1, 0.3})
    for (const bool floor : {false, true}) {
      const Vec3 left = passed(thickness, glass, floor);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(left[k], std::exp(-2 * k * thickness), 0.05)
            << thickness << ", colour " << k << (floor ? ", with a floor" : "");
    }
}

TEST(PathPicture, GlassMirrorsByItsIndex) {
  for (const float index : {1.25f, 1.5f, 2.5f}) {
    Glass glass;
    glass.share = 1, glass.index = index;
    glass.absorbed_per_unit = {0, 0, 0};
    // At right angles, on both sides of the slab, to and fro.
    const double mirrored = std::pow((index - 1) / (index + 1), 2);
    EXPECT_NEAR(passed(0.1, glass, false).mean(), (1 - mirrored) / (1 + mirrored), 0.05) << index;
  }
}

TEST(PathPicture, NoiseFallsWithSamplesAndByTheFilter) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  const PictureScene scene = scene_of(mesh);
  const Camera camera = looking(Vec3(0, -5, 3), Vec3(0.5, 0, 0.5));
  PathOptions plain;
  plain.filter = false;
  const Image converged = trace_picture(scene, camera, small(512), plain);
  const double four = rmse(trace_picture(scene, camera, small(4), plain), converged);
  const double sixteen = rmse(trace_picture(scene, camera, small(16), plain), converged);
  const double filtered = rmse(trace_picture(scene, camera, small(4)), converged);
  EXPECT_LT(sixteen, 0.7 * four);
  EXPECT_LT(filtered, 0.75 * four);
}

TEST(PathPicture, BackgroundStaysAsItIs) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  PictureScene scene = scene_of(mesh);
  scene.floor = false;
  PictureOptions options = small(4);
  options.background = {1, 0, 0, 0.5f};
  const Image image = trace_picture(scene, std::nullopt, options);
  const std::uint8_t* corner = image.pixel(0, 0);
  EXPECT_EQ(corner[0], 255);
  EXPECT_EQ(corner[1], 0);
  EXPECT_EQ(corner[3], 128);
  EXPECT_EQ(image.pixel(48, 36)[3], 255);
  EXPECT_GT(image.pixel(48, 36)[1], 40);
}

TEST(PathPicture, HasTheSameBytesForAnyNumberOfThreads) {
  Boxes boxes = grey_room();
  boxes.materials[1].base_colour[3] = 0.3f;
  const PictureMesh mesh = boxes.view();
  const auto with = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Image image;
    tbb::task_arena(threads).execute(
        [&] { image = trace_picture(scene_of(mesh), std::nullopt, small(4)); });
    return image.rgba;
  };
  const auto one = with(1);
  EXPECT_EQ(one, with(2));
  EXPECT_EQ(one, with(7));
}

TEST(PathPicture, IsTheSameFarFromTheOrigin) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  PictureScene near = scene_of(mesh), far = scene_of(mesh, Vec3(1e6, -1e6, 0));
  near.floor = far.floor = false;
  EXPECT_LT(
      rmse(trace_picture(near, std::nullopt, small(4)), trace_picture(far, std::nullopt, small(4))),
      0.5);
}

TEST(PathPicture, BearsBadMeshesAndCameras) {
  Boxes boxes = grey_room();
  boxes.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  boxes.triangles.push_back({0, 0, 1});
  boxes.triangles.push_back({8, 9, 9});
  const PictureMesh mesh = boxes.view();
  for (const double fov : {1.0, 40.0, 170.0})
    for (const Vec3& eye : {Vec3(0.2, 0.1, 0.5), Vec3(0, -3, 1), Vec3(0, 0, -2), Vec3(1e7, 0, 1)})
      EXPECT_EQ(trace_picture(scene_of(mesh), looking(eye, Vec3(1, 2, 0.3), fov), small(2, 16, 12))
                    .rgba.size(),
                16u * 12 * 4);
  EXPECT_EQ(trace_picture({{}, true}, std::nullopt, small(2)).width, 96);
  EXPECT_EQ(trace_picture({{}, false}, std::nullopt, small(2)).pixel(5, 5)[0], 255);
}

TEST(PathPicture, RefusesBadOptions) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  const auto expect_refused = [&](const PictureOptions& options, const PathOptions& path,
                                  const std::string& named) {
    try {
      trace_picture(scene_of(mesh), std::nullopt, options, path);
      ADD_FAILURE() << "accepted " << named;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::BadInput);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  expect_refused(small(0), {}, "0 samples");
  expect_refused(small(1, 0, 5), {}, "0 x 5");
  PathOptions path;
  path.bounces = -1;
  expect_refused(small(), path, "-1 bounces");
}

TEST(PathPicture, StopsWhenProgressThrows) {
  const Boxes boxes = grey_room();
  const PictureMesh mesh = boxes.view();
  struct Stop {};
  PictureOptions options = small(4);
  int num_calls = 0;
  options.progress = [&](double) {
    if (++num_calls == 3) throw Stop{};
  };
  EXPECT_THROW(trace_picture(scene_of(mesh), std::nullopt, options), Stop);
  EXPECT_LT(num_calls, 9);
}

TEST(Sampler, FillsEachAxisEvenly) {
  for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
    std::array<std::set<int>, 4> columns, rows;
    for (std::uint32_t s = 0; s < 16; ++s) {
      Sampler sampler(pixel, s);
      for (int pair = 0; pair < 4; ++pair) {
        const Sampler::Pair u = sampler.next();
        ASSERT_TRUE(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
        columns[pair].insert(int(16 * u.x));
        rows[pair].insert(int(16 * u.y));
      }
    }
    for (int pair = 0; pair < 4; ++pair) {
      EXPECT_EQ(columns[pair].size(), 16u);
      EXPECT_EQ(rows[pair].size(), 16u);
    }
  }
}

}  // namespace
}  // namespace trivet
