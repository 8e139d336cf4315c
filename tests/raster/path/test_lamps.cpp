// Lamps of known strength, their shadows, and lenses: what is in focus stays sharp.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "raster/path/environment.h"
#include "raster/path/lamps.h"
#include "raster/path/picture.h"

namespace trivet {
namespace {

/// A plate of 20 cm, dark on its left half, seen from above.
struct Plate {
  std::vector<Vec3> vertices{{-0.1, -0.1, 1e-3}, {0, -0.1, 1e-3},   {0, 0.1, 1e-3},
                             {-0.1, 0.1, 1e-3},  {0.1, -0.1, 1e-3}, {0.1, 0.1, 1e-3}};
  std::vector<Index3> triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  std::vector<Index> faces{0, 0, 1, 1};
  std::vector<Material> materials{{"dark", {0.02f, 0.02f, 0.02f, 1}, 0, 1},
                                  {"light", {0.8f, 0.8f, 0.8f, 1}, 0, 1}};
  PictureMesh mesh;
  PictureScene scene;

  Plate() {
    mesh.vertices = vertices, mesh.triangles = triangles;
    mesh.face_material = faces, mesh.materials = materials;
    PictureObject object;
    object.mesh = &mesh;
    object.world_from_object.linear = Mat3::Identity();
    scene.objects = {object};
    scene.floor = false;
  }
  Image picture(const PictureLook& look, int samples = 64) const {
    PictureOptions options;
    options.width = options.height = 40, options.samples = samples;
    Camera camera;
    camera.eye = Vec3(0, 0, 0.6), camera.up = Vec3::UnitY(), camera.fov_deg = 20;
    PathOptions path;
    path.look = look;
    path.filter = false;
    return trace_picture(scene, camera, options, path);
  }
};

double grey_of(const Image& image, int x, int y) { return image.pixel(x, y)[0]; }

PictureLook lit_by(const PictureLamp& lamp) {
  PictureLook look;
  look.sky_colour = Vec3::Zero();
  look.lamps = {lamp};
  return look;
}

LampLight light_at(const PictureLook& look, const Vec3f& point, Sampler::Pair u = {0, 0}) {
  const PictureLights lights(
      16, FrameCamera{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitZ()});
  PictureFrame frame;
  frame.scale = 2;
  return Lamps(look, lights, frame).towards(point, u);
}

double key_light() {
  PictureLook plain;
  return light_at(plain, Vec3f::Zero()).irradiance.mean();
}

TEST(Lamps, AreAsStrongAsTheySayInTheMiddle) {
  for (const auto kind :
       {PictureLamp::Kind::Sun, PictureLamp::Kind::Bulb, PictureLamp::Kind::Panel}) {
    PictureLamp lamp;
    lamp.kind = kind, lamp.towards = Vec3(0, 3, 4), lamp.distance = 1.5, lamp.size = 0;
    lamp.colour = Vec3(1, 2, 0.5);
    const LampLight light = light_at(lit_by(lamp), Vec3f::Zero());
    EXPECT_NEAR((light.direction - Vec3f(0, 0.6f, 0.8f)).norm(), 0, 1e-6);
    EXPECT_NEAR(light.irradiance.x() / key_light(), 1, 0.05);
    EXPECT_NEAR(light.irradiance.y() / light.irradiance.x(), 2, 1e-5);
    if (kind != PictureLamp::Kind::Sun) {
      EXPECT_NEAR(light.distance, 3, 1e-5) << "the frame is twice as large";
    }
  }
}

TEST(Lamps, BulbsFallOffWithTheSquareAndPanelsShineForward) {
  PictureLamp lamp;
  lamp.kind = PictureLamp::Kind::Bulb, lamp.distance = 1, lamp.size = 0;
  const double middle = light_at(lit_by(lamp), Vec3f::Zero()).irradiance.x();
  EXPECT_NEAR(light_at(lit_by(lamp), Vec3f(0, 0, -2)).irradiance.x() / middle, 0.25, 1e-5);
  EXPECT_NEAR(light_at(lit_by(lamp), Vec3f(0, 0, 1)).irradiance.x() / middle, 4, 1e-4);
  EXPECT_NEAR(light_at(lit_by(lamp), Vec3f(0, 0, 4)).irradiance.x() / middle, 1, 1e-5);
  lamp.kind = PictureLamp::Kind::Panel;
  EXPECT_EQ(light_at(lit_by(lamp), Vec3f(0, 0, 4)).irradiance.x(), 0) << "behind it";
  EXPECT_NEAR(light_at(lit_by(lamp), Vec3f(2, 0, 0)).irradiance.x() / middle, 0.5 * std::sqrt(0.5),
              1e-4);
}

TEST(Lamps, SeveralAreDrawnSoThatTheirSumIsRight) {
  PictureLook look;
  PictureLamp strong, weak;
  strong.towards = Vec3(1, 0, 0), strong.size = 0, strong.colour = Vec3::Constant(3);
  weak.towards = Vec3(0, 1, 0), weak.size = 0, weak.colour = Vec3::Constant(1);
  look.lamps = {strong, weak};
  double sums[2] = {0, 0};
  int num_strong = 0;
  constexpr int kDraws = 4096;
  for (int i = 0; i < kDraws; ++i) {
    const LampLight light = light_at(look, Vec3f::Zero(), {(float(i) + 0.5f) / kDraws, 0.5f});
    const bool is_strong = light.direction.x() > 0.5f;
    num_strong += is_strong ? 1 : 0;
    sums[is_strong ? 0 : 1] += light.irradiance.x() / kDraws;
  }
  EXPECT_NEAR(sums[0] / key_light(), 3, 0.15);
  EXPECT_NEAR(sums[1] / key_light(), 1, 0.05);
  EXPECT_GT(num_strong, kDraws / 2);
  EXPECT_LT(num_strong, kDraws * 4 / 5);
}

TEST(Lamps, LightPictures) {
  const Plate plate;
  PictureLamp lamp;
  lamp.towards = Vec3(0.2, 0, 1), lamp.size = 0.01;
  PictureLook dark = lit_by(lamp);
  dark.lamps[0].colour = Vec3::Zero();
  EXPECT_LT(grey_of(plate.picture(dark), 30, 20), 5);
  PictureLook red = lit_by(lamp);
  red.lamps[0].colour = Vec3(1, 0.01, 0.01);
  const Image image = plate.picture(red);
  EXPECT_GT(image.pixel(30, 20)[0], 100);
  EXPECT_LT(image.pixel(30, 20)[1], 60);
  lamp.kind = PictureLamp::Kind::Panel, lamp.distance = 0.5, lamp.towards = Vec3(0.3, 0, 0.4);
  const Image panel = plate.picture(lit_by(lamp));
  EXPECT_GT(grey_of(panel, 30, 20), 100);
  EXPECT_NEAR(grey_of(plate.picture(lit_by(lamp)), 30, 20), grey_of(panel, 30, 20), 0);
}

double linear_of_srgb(double byte) {
  const double c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Light of the plate's right half, where the film is linear still.
double light_of(const Plate& plate, const PictureLook& look) {
  const Image image = plate.picture(look, 256);
  double sum = 0;
  for (int y = 14; y < 26; ++y)
    for (int x = 24; x < 36; ++x) sum += linear_of_srgb(grey_of(image, x, y));
  return sum / 144;
}

std::shared_ptr<const EnvironmentMap> even_surroundings(float radiance) {
  return std::make_shared<EnvironmentMap>(FloatImage{16, 8, std::vector<float>(3 * 128, radiance)});
}

// Each of the three has its share, whichever is the strongest.
TEST(Lamps, AddUpWithAnEnvironmentAndTheKeyLight) {
  const Plate plate;
  PictureLamp lamp;
  lamp.kind = PictureLamp::Kind::Panel, lamp.distance = 0.5, lamp.towards = Vec3(0.3, 0, 0.4);
  PictureLook around;
  around.environment = even_surroundings(0.2f);
  const double environment = light_of(plate, around);
  EXPECT_NEAR(environment, 0.16, 0.02) << "albedo 0.8";
  for (const double strength : {0.02, 0.1, 0.3}) {
    lamp.colour = Vec3::Constant(strength);
    PictureLook by_lamp = lit_by(lamp), by_key = lit_by(lamp), all = around;
    by_key.lamps.clear(), by_key.key_colour = Vec3::Constant(0.1);
    all.lamps = {lamp};
    const double of_lamp = light_of(plate, by_lamp), of_key = light_of(plate, by_key);
    EXPECT_NEAR(light_of(plate, all) / (environment + of_lamp), 1, 0.03) << strength;
    all.key_beside = true, all.key_colour = by_key.key_colour;
    EXPECT_NEAR(light_of(plate, all) / (environment + of_lamp + of_key), 1, 0.03) << strength;
    by_lamp.key_beside = true, by_lamp.key_colour = by_key.key_colour;
    EXPECT_NEAR(light_of(plate, by_lamp) / (of_lamp + of_key), 1, 0.03) << strength;
  }
}

TEST(Lamps, AreInTheDarkBesideABrightEnvironment) {
  PictureLook look;
  look.environment = even_surroundings(1);
  const PictureLights lights(
      16, FrameCamera{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitZ()});
  EXPECT_EQ(Lamps(look, lights, {}).irradiance(), 0) << "no key light by itself";
  look.key_beside = true;
  EXPECT_NEAR(Lamps(look, lights, {}).irradiance() / key_light(), 1, 0.05);
  look.lamps.resize(2);
  EXPECT_NEAR(Lamps(look, lights, {}).irradiance() / key_light(), 3, 0.1);
}

double step_at_edge(const Image& image) {  // of the two pixels across the middle
  return (grey_of(image, 20, 20) - grey_of(image, 19, 20)) /
         (grey_of(image, 30, 20) - grey_of(image, 8, 20));
}

TEST(Lens, BlursWhatIsOutOfFocusAlone) {
  const Plate plate;
  PictureLook look;
  const double sharp = step_at_edge(plate.picture(look));
  EXPECT_GT(sharp, 0.85);
  look.f_number = 1;
  EXPECT_GT(step_at_edge(plate.picture(look, 256)), 0.75) << "the plate is in focus";
  look.focus = 0.5;
  EXPECT_LT(step_at_edge(plate.picture(look, 256)), 0.35);
  look.f_number = 500;
  EXPECT_GT(step_at_edge(plate.picture(look, 256)), 0.75) << "a small hole";
}

TEST(Lens, AndLampsRefuseWhatNoneHas) {
  const Plate plate;
  const auto refuses = [&](const PictureLook& look) {
    EXPECT_THROW(plate.picture(look, 1), Error);
  };
  PictureLook look;
  look.f_number = -1;
  refuses(look);
  look = {}, look.focus = 0;
  refuses(look);
  PictureLamp lamp;
  lamp.towards = Vec3::Zero();
  refuses(lit_by(lamp));
  lamp = {}, lamp.distance = 0;
  refuses(lit_by(lamp));
  lamp = {}, lamp.colour = Vec3::Constant(-1);
  refuses(lit_by(lamp));
  look = {}, look.lamps.resize(1000);
  refuses(look);
}

}  // namespace
}  // namespace trivet
