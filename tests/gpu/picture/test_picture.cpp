// Offscreen pictures of scenes with known coverage, light, shadow and occlusion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "gpu/picture/picture.h"
#include "support/mesa_leaks.h"

namespace trivet {
namespace {

constexpr std::array<float, 4> kWhite{1, 1, 1, 1};

/// Axis-aligned boxes as one mesh.
struct Boxes {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;
  std::vector<Material> materials = {Material{}};

  void add(const Vec3& lower, const Vec3& upper) {
    static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const Index first = static_cast<Index>(vertices.size());
    for (int i = 0; i < 8; ++i)
      vertices.push_back({i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                          i & 4 ? upper.z() : lower.z()});
    for (const auto& s : kSides) {
      triangles.push_back({first + s[0], first + s[1], first + s[2]});
      triangles.push_back({first + s[0], first + s[2], first + s[3]});
    }
  }
  PictureMesh view() const {
    PictureMesh mesh;
    mesh.vertices = vertices;
    mesh.triangles = triangles;
    mesh.materials = materials;
    return mesh;
  }
};

Boxes cube() {
  Boxes boxes;
  boxes.add(Vec3(-1, -1, 0), Vec3(1, 1, 2));
  return boxes;
}

PictureScene scene_of(const PictureMesh& mesh, double scale = 1) {
  PictureObject object;
  object.mesh = &mesh;
  object.world_from_object.linear *= scale;
  return {{object}, true};
}

double brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return (p[0] + p[1] + p[2]) / 3.0;
}

/// Looks straight down on the origin from 10 m, the picture 8 m high; +x to the right, +y up.
Camera from_above() {
  Camera camera;
  camera.eye = Vec3(0, 0, 10);
  camera.target = Vec3::Zero();
  camera.up = Vec3::UnitY();
  camera.fov_deg = 2 * std::atan(0.4) * 180 / 3.14159265358979;
  return camera;
}

PictureOptions small(int width = 160, int height = 120) {
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.samples = 8;
  options.background = kWhite;
  return options;
}

class Picture : public testing::Test {
 protected:
  void SetUp() override {
    try {
      m_context = std::make_unique<EglContext>();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  Image render(const PictureScene& scene, const std::optional<Camera>& camera,
               const PictureOptions& options) {
    return render_picture(*m_context, scene, camera, options);
  }
  void expect_bad_input(const PictureScene& scene, const std::optional<Camera>& camera,
                        const PictureOptions& options, const std::string& named) {
    try {
      render(scene, camera, options);
      ADD_FAILURE() << "accepted " << named;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::BadInput);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  }
  std::unique_ptr<EglContext> m_context;
};

TEST_F(Picture, KeepsMeshesWhileTheirModelsLive) {
  const Boxes boxes = cube();
  PictureMesh mesh = boxes.view();
  auto model = std::make_shared<const int>(0);
  mesh.source = model;
  const PictureScene scene = scene_of(mesh);
  const PictureOptions options = small();
  PictureDrawer drawer(*m_context);
  const Image first = drawer.render(scene, std::nullopt, options);
  const Image again = drawer.render(scene, std::nullopt, options);
  EXPECT_EQ(first.rgba, again.rgba);
  EXPECT_EQ(first.rgba, render(scene, std::nullopt, options).rgba);
  EXPECT_EQ(drawer.num_meshes_sent(), 1u);

  model = std::make_shared<const int>(1);  // another one, though with the same arrays
  mesh.source = model;
  EXPECT_EQ(drawer.render(scene, std::nullopt, options).rgba, first.rgba);
  EXPECT_EQ(drawer.num_meshes_sent(), 2u);
  mesh.source.reset();
  drawer.render(scene, std::nullopt, options);
  drawer.render(scene, std::nullopt, options);
  EXPECT_EQ(drawer.num_meshes_sent(), 4u);
}

TEST_F(Picture, ShowsCubeAgainstBackground) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureScene scene = scene_of(mesh);
  scene.floor = false;
  PictureOptions options = small();
  options.background = {1, 0, 0, 1};
  const Image image = render(scene, std::nullopt, options);
  EXPECT_GT(image.pixel(80, 60)[1], 40);  // grey, not the background's red
  for (const auto& [x, y] : {std::pair(0, 0), {159, 0}, {0, 119}, {159, 119}}) {
    EXPECT_EQ(image.pixel(x, y)[0], 255);
    EXPECT_EQ(image.pixel(x, y)[1], 0);
  }
}

TEST_F(Picture, FramesSceneTightly) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureScene scene = scene_of(mesh);
  scene.floor = false;
  const PictureOptions options = small(200, 200);
  const Image image = render(scene, std::nullopt, options);
  int left = 200, right = -1, top = 200, bottom = -1;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      if (brightness(image, x, y) < 250) {
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
  EXPECT_GT(std::min(left, top), 2);
  EXPECT_LT(std::max(right, bottom), 197);
  EXPECT_GT(std::max(right - left, bottom - top), 140);
  EXPECT_NEAR(left + right, 199, 3);
  EXPECT_NEAR(top + bottom, 199, 3);
}

/// Region where shadows darken a picture of 120 x 120 pixels clearly.
struct Darkened {
  int count = 0;
  double strongest = 1;    // ratio of brightness, with shadows to without
  double farthest_px = 0;  // from the centre of the picture
};

Darkened compare(const Image& with, const Image& without) {
  Darkened out;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      const double ratio = brightness(with, x, y) / brightness(without, x, y);
      out.strongest = std::min(out.strongest, ratio);
      if (ratio > 0.85) continue;
      ++out.count;
      out.farthest_px = std::max(out.farthest_px, std::hypot(x - 59.5, y - 59.5));
    }
  return out;
}

TEST_F(Picture, CastsShadowOnFloor) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(120, 120);
  options.ambient_occlusion = false;
  options.samples = 16;
  const Image with = render(scene_of(mesh), from_above(), options);
  options.shadows = false;
  const Image without = render(scene_of(mesh), from_above(), options);
  const Darkened shadow = compare(with, without);
  EXPECT_LT(shadow.strongest, 0.75);
  EXPECT_GT(shadow.count, 200);
  // The key light stands at 52 degrees: the shadow ends 1.6 m from the cube's edge, 15 px per m.
  EXPECT_LT(shadow.farthest_px, 15 * (1.42 + 1.6 + 0.6));
  EXPECT_NEAR(brightness(with, 60, 60), brightness(without, 60, 60), 2.0) << "the top of the cube";
}

// Smooth normals over a sharp fold bulge far out of the triangle. Shadow rays that followed them
// started above the objects on the triangle: a breakfast on a folded table-cloth had no shadows.
TEST_F(Picture, KeepsShadowsOnTrianglesWithBentNormals) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  const std::vector<Vec3> corners = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
  const std::vector<Index3> triangles = {{0, 1, 2}, {0, 2, 3}};
  std::vector<std::array<Eigen::Vector3f, 3>> normals(2);
  for (int f = 0; f < 2; ++f)
    for (int c = 0; c < 3; ++c)
      normals[f][c] = (corners[triangles[f][c]] * 0.15 + Vec3::UnitZ()).normalized().cast<float>();
  PictureMesh cloth;
  cloth.vertices = corners;
  cloth.triangles = triangles;
  cloth.corner_normals = normals;
  PictureScene scene = scene_of(mesh);
  scene.floor = false;
  scene.objects.push_back({&cloth, Affine{}, std::nullopt});
  PictureOptions options = small(120, 120);
  options.ambient_occlusion = false;
  options.samples = 16;
  const Image with = render(scene, from_above(), options);
  options.shadows = false;
  const Darkened shadow = compare(with, render(scene, from_above(), options));
  EXPECT_LT(shadow.strongest, 0.75);
  EXPECT_GT(shadow.count, 200);
}

TEST_F(Picture, DarkensFloorAtContact) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(160, 160);
  options.shadows = false;
  options.samples = 32;
  const Image image = render(scene_of(mesh), from_above(), options);
  // One metre is 20 pixels on the floor; the cube's top, nearer, ends at 80 + 25.
  for (const double direction : {-1.0, 1.0}) {
    const auto at = [&](double metres) {
      return brightness(image, static_cast<int>(80 + direction * 20 * metres), 80);
    };
    EXPECT_LT(at(1.35), at(1.9));
    EXPECT_LT(at(1.9), at(2.6));
  }
}

TEST_F(Picture, LooksTheSameFromMillimetreToKilometre) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  const PictureOptions options = small();
  const Image metre = render(scene_of(mesh), std::nullopt, options);
  for (const double scale : {5e-4, 500.0}) {
    const Image other = render(scene_of(mesh, scale), std::nullopt, options);
    int different = 0;
    for (std::size_t i = 0; i < metre.rgba.size(); ++i)
      different += std::abs(metre.rgba[i] - other.rgba[i]) > 6;
    EXPECT_LT(different, static_cast<int>(metre.rgba.size() / 200)) << scale;
  }
}

TEST_F(Picture, IsDeterministic) {
  Boxes boxes = cube();
  boxes.materials[0].base_colour[3] = 0.4f;  // transparency is stochastic, but with the same seeds
  const PictureMesh mesh = boxes.view();
  const Image a = render(scene_of(mesh), std::nullopt, small());
  const Image b = render(scene_of(mesh), std::nullopt, small());
  EXPECT_EQ(a.rgba, b.rgba);
}

int largest_difference(const Image& a, const Image& b, int shift_x, int shift_y) {
  int out = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (x + shift_x >= b.width || y + shift_y >= b.height) continue;
      for (int c = 0; c < 4; ++c)
        out = std::max(out, std::abs(a.pixel(x, y)[c] - b.pixel(x + shift_x, y + shift_y)[c]));
    }
  return out;
}

// The same view by focal lengths, and a part of it by another principal point.
TEST_F(Picture, TakesPinholeCameras) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  const PictureScene scene = scene_of(mesh);
  PictureOptions options;
  options.width = 96, options.height = 64, options.samples = 4;
  Camera camera;
  camera.eye = Vec3(5, -7, 4), camera.target = Vec3(0.3, 0.2, 0.9);
  const Image expected = render(scene, camera, options);
  PinholeCamera pinhole = pinhole_camera(camera, options.width, options.height);
  EXPECT_LE(largest_difference(expected, render_picture(*m_context, scene, pinhole, options), 0, 0),
            2);
  pinhole.cx -= 20, pinhole.cy -= 12;
  pinhole.width = 60, pinhole.height = 48;
  const Image part = render_picture(*m_context, scene, pinhole, options);
  ASSERT_EQ(part.width, 60);
  EXPECT_LE(largest_difference(part, expected, 20, 12), 2);
  EXPECT_GE(largest_difference(part, expected, 0, 0), 50) << "it is another part";
  pinhole.fx = 0;
  EXPECT_THROW(render_picture(*m_context, scene, pinhole, options), Error);
}

TEST_F(Picture, HasNoShadowAcne) {
  Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(120, 120);
  options.samples = 16;
  const Image image = render(scene_of(mesh), from_above(), options);
  const double middle = brightness(image, 60, 60);
  for (int y = 45; y <= 75; ++y)
    for (int x = 45; x <= 75; ++x) EXPECT_NEAR(brightness(image, x, y), middle, 3.0);
}

TEST_F(Picture, AcceptsOddSizes) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  for (const auto& [w, h] : {std::pair(333, 17), {17, 333}, {1, 1}, {2, 3}}) {
    const Image image = render(scene_of(mesh), std::nullopt, small(w, h));
    EXPECT_EQ(image.width, w);
    EXPECT_EQ(image.height, h);
    EXPECT_EQ(image.rgba.size(), std::size_t{4} * w * h);
  }
}

TEST_F(Picture, JoinsTilesWithoutSeam) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(2200, 8);
  options.samples = 4;
  const Image image = render(scene_of(mesh), from_above(), options);
  // On the open floor, left and right of the first pixel of the second tile.
  for (int y = 0; y < 8; ++y)
    EXPECT_NEAR(brightness(image, 2047, y), brightness(image, 2048, y), 3.0);
}

TEST_F(Picture, RefusesOptionsOutOfRange) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  const PictureScene scene = scene_of(mesh);
  expect_bad_input(scene, std::nullopt, small(0, 10), "0 x 10");
  expect_bad_input(scene, std::nullopt, small(10, 16385), "16385");
  expect_bad_input(scene, std::nullopt, small(-3, 10), "16384");
  PictureOptions options = small();
  options.samples = 0;
  expect_bad_input(scene, std::nullopt, options, "0 samples");
  options = small();
  options.background[2] = std::numeric_limits<float>::quiet_NaN();
  expect_bad_input(scene, std::nullopt, options, "background");
  Camera camera;
  camera.fov_deg = 200;
  expect_bad_input(scene, camera, small(), "200");
  camera = Camera();
  camera.eye = camera.target;
  expect_bad_input(scene, camera, small(), "eye");
  PictureScene nowhere = scene;
  nowhere.objects[0].world_from_object.translation.x() = kInfinity;
  expect_bad_input(nowhere, std::nullopt, small(), "object 0");
}

TEST_F(Picture, HandlesScenesWithoutVisibleObjects) {
  const PictureOptions options = small(40, 30);
  EXPECT_EQ(render({{}, true}, std::nullopt, options).rgba.size(), 4800u);
  EXPECT_EQ(render({{}, false}, std::nullopt, options).pixel(20, 15)[0], 255);
  Boxes point;
  point.add(Vec3(1, 2, 3), Vec3(1, 2, 3));
  Boxes line;
  line.add(Vec3(0, 0, 0), Vec3(0, 0, 5));
  Boxes broken = cube();
  broken.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  broken.vertices[4].y() = kInfinity;
  Boxes flat;
  flat.add(Vec3(-1, -1, 0), Vec3(1, 1, 0));
  for (const Boxes* boxes : {&point, &line, &broken, &flat}) {
    const PictureMesh mesh = boxes->view();
    for (const double scale : {1.0, 0.0})
      EXPECT_NO_THROW(render(scene_of(mesh, scale), std::nullopt, options));
  }
}

TEST_F(Picture, BlendsByAlpha) {
  Boxes boxes = cube();
  boxes.materials[0].base_colour = {0, 0, 0, 0.5f};
  const PictureMesh mesh = boxes.view();
  PictureScene scene = scene_of(mesh);
  scene.floor = false;
  PictureOptions options = small();
  options.samples = 64;
  options.background = {0, 0, 0, 0};
  const Image image = render(scene, std::nullopt, options);
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  EXPECT_GT(image.pixel(80, 60)[3], 110);
  EXPECT_LT(image.pixel(80, 60)[3], 245);
}

TEST_F(Picture, HighlightsObjects) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureScene scene = scene_of(mesh);
  scene.objects[0].highlight = {1, 0, 0, 0.9f};
  const Image image = render(scene, std::nullopt, small());
  EXPECT_GT(image.pixel(80, 60)[0], image.pixel(80, 60)[1] + 40);
}

TEST_F(Picture, ReportsProgress) {
  const Boxes boxes = cube();
  const PictureMesh mesh = boxes.view();
  PictureOptions options = small(20, 20);
  std::vector<double> fractions;
  options.progress = [&](double fraction) { fractions.push_back(fraction); };
  render(scene_of(mesh), std::nullopt, options);
  ASSERT_EQ(fractions.size(), 8u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_DOUBLE_EQ(fractions.back(), 1.0);
}

}  // namespace
}  // namespace trivet
