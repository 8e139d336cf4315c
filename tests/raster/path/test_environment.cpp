// Environment maps and looks: known brightness, even drawing, and files that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "raster/path/environment.h"
#include "raster/path/picture.h"

namespace trivet {
namespace {

FloatImage image_of(int height, const Vec3f& light) {
  FloatImage out{2 * height, height, {}};
  for (int i = 0; i < 2 * height * height; ++i)
    out.rgb.insert(out.rgb.end(), light.data(), light.data() + 3);
  return out;
}

// A dim sky with a small sun at 45 degrees.
FloatImage with_sun() {
  FloatImage out = image_of(64, Vec3f(0.1f, 0.2f, 0.3f));
  for (int k = 0; k < 3; ++k) out.rgb[3 * (16 * 128 + 40) + k] = 5000;
  return out;
}

Vec3f mean_of_draws(const EnvironmentMap& map, int count, int* num_sun = nullptr) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    Sampler sampler(17, static_cast<std::uint32_t>(i));
    const EnvironmentMap::Drawn drawn = map.draw(sampler.next());
    EXPECT_NEAR(drawn.direction.norm(), 1, 1e-5);
    sum += drawn.weight.cast<double>();
    if (num_sun) *num_sun += map.radiance(drawn.direction).x() > 100 ? 1 : 0;
  }
  return (sum / count).cast<float>();
}

TEST(Environment, DrawsItsLight) {
  const float sphere = 4 * std::numbers::pi_v<float>;
  const EnvironmentMap even(image_of(8, Vec3f(1, 2, 3)));
  EXPECT_NEAR((even.mean() - Vec3f(1, 2, 3)).norm(), 0, 1e-5);
  EXPECT_NEAR((mean_of_draws(even, 4096) / sphere - Vec3f(1, 2, 3)).norm(), 0, 0.02);
  const EnvironmentMap sunny(with_sun());
  int num_sun = 0;
  const Vec3f drawn = mean_of_draws(sunny, 4096, &num_sun) / sphere;
  EXPECT_NEAR((drawn - sunny.mean()).norm() / sunny.mean().norm(), 0, 0.02);
  EXPECT_GT(num_sun, 1024) << "the sun has most of the light";
  EXPECT_NEAR((even.radiance(Vec3f(0.6f, 0, 0.8f)) - Vec3f(1, 2, 3)).norm(), 0, 1e-5);
}

TEST(Environment, IsLookedUpWhereItIsDrawn) {
  const EnvironmentMap sunny(with_sun());
  const EnvironmentMap::Drawn drawn = sunny.draw({0.3f, 0.25f});
  EXPECT_GT(sunny.radiance(drawn.direction).x(), 100);
  EXPECT_LT(sunny.radiance(-drawn.direction).x(), 1);
  EXPECT_NEAR(drawn.direction.z(), std::sqrt(0.5f), 0.05);
}

TEST(Environment, RefusesOtherImages) {
  EXPECT_THROW(EnvironmentMap(FloatImage{3, 2, std::vector<float>(18, 1)}), Error);
  EXPECT_THROW(EnvironmentMap(FloatImage{4, 2, std::vector<float>(24, 0)}), Error);
}

TEST(Environment, ReadsOpenExr) {
  std::vector<float> values(3 * 8 * 4);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) - 1;
  std::string bytes;
  try {
    bytes = encode_exr(8, 4, 3, values);  // channels X, Y, Z: Y is read as grey
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  const FloatImage image = decode_exr(bytes);
  ASSERT_EQ(image.width, 8);
  ASSERT_EQ(image.height, 4);
  for (std::size_t i = 0; i < 32; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(image.rgb[3 * i + k], float(3 * i));
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_THROW(decode_exr(bytes.substr(0, size)), Error) << size;
  EXPECT_THROW(decode_exr("no image"), Error);
}

struct Flat {
  std::vector<Vec3> vertices{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
  std::vector<Index3> triangles{{0, 1, 2}};
  PictureMesh mesh;
  PictureScene scene;
  Flat() {
    mesh.vertices = vertices, mesh.triangles = triangles;
    PictureObject object;
    object.mesh = &mesh;
    object.world_from_object.translation = Vec3(0, 0, 1e-4);
    scene.objects = {object};
  }
  Image picture(const PathOptions& path, const Vec3& target = Vec3::Zero()) const {
    PictureOptions options;
    options.width = options.height = 24, options.samples = 64;
    Camera camera;
    camera.eye = Vec3(0.3, -0.6, 0.4), camera.target = target;
    return trace_picture(scene, camera, options, path);
  }
};

TEST(Look, FloorUnderAnEvenSkyHasItsColour) {
  PathOptions path;
  path.look.environment = std::make_shared<EnvironmentMap>(image_of(16, Vec3f(1, 1, 1)));
  path.look.floor_colour = Vec3(0.5, 0.5, 0.5);
  const Image floor = Flat().picture(path, Vec3(0.5, 0.5, 0));
  EXPECT_NEAR(floor.pixel(12, 12)[0], 191, 3);  // sRGB of 0.52: 4 % are mirrored
  path.look.environment_strength = 0.3;
  const Image sky = Flat().picture(path, Vec3(0.3, 0.4, 0.9));
  EXPECT_NEAR(sky.pixel(12, 12)[0], 149, 2);  // sRGB of 0.3
  EXPECT_EQ(sky.pixel(12, 12)[3], 255);
}

TEST(Look, ChangesWhatItSays) {
  const Flat flat;
  const PathOptions plain;
  const auto grey = [&](const PathOptions& path) {
    return double(flat.picture(path).pixel(10, 12)[0]);  // the floor beside it
  };
  const double as_usual = grey(plain);
  PathOptions path = plain;
  path.look.exposure = 0.5;
  EXPECT_LT(grey(path), 0.85 * as_usual);
  path = plain, path.look.floor_colour = Vec3(0.1, 0.6, 0.6);
  EXPECT_LT(grey(path), 0.7 * as_usual);
  path = plain, path.look.key_colour = Vec3::Constant(0.2);
  EXPECT_LT(grey(path), 0.9 * as_usual);
  path = plain, path.look.noise = 0.05, path.look.noise_seed = 3;
  const Image noisy = flat.picture(path), clean = flat.picture(plain);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < clean.rgba.size(); i += 4) {
    const double difference = (double(noisy.rgba[i]) - clean.rgba[i]) / 255;
    sum += difference, squares += difference * difference;
  }
  const double count = double(clean.rgba.size()) / 4;
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.008);
  EXPECT_NEAR(sum / count, 0, 0.008);
  for (auto bad : {&PictureLook::exposure, &PictureLook::noise}) {
    path = plain, path.look.*bad = -1;
    EXPECT_THROW(flat.picture(path), Error);
  }
  path = plain, path.look.key = Vec3::Zero();
  EXPECT_THROW(flat.picture(path), Error);
}

}  // namespace
}  // namespace trivet
