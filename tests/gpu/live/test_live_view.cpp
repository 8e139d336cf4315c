// Live views of scenes with a known appearance: shadows, outlines, ghosts, overlays.
#include "live_stage.h"
#include "support/mesa_leaks.h"

namespace trivet {
namespace {

using namespace test;

TEST_F(Live, ComputesWidthOfPixel) {
  for (const bool orthographic : {false, true}) {
    LiveCamera camera;
    camera.eye = Vec3(3, -4, 5);
    camera.target = Vec3(0.5, 0.2, 0.1);
    if (orthographic) camera.height = 2.5;
    const double wide = metres_per_pixel(camera.target, camera, kHeight);
    const Vec3 right = (camera.target - camera.eye).cross(Vec3::UnitZ()).normalized();
    const Vec2 moved = pixel(camera, camera.target + 10 * wide * right);
    EXPECT_NEAR(moved.x(), 0.5 * kWidth + 10, 1e-6);
    EXPECT_NEAR(moved.y(), 0.5 * kHeight, 1e-6);
  }
}

TEST_F(Live, FramesBox) {
  const Aabb box{Vec3(1, 2, 3), Vec3(5, 3, 4)};
  for (const bool orthographic : {false, true}) {
    LiveCamera camera;
    if (orthographic) camera.height = 1;
    camera = framed(camera, box, 1.5);
    double widest = 0;
    for (int i = 0; i < 8; ++i) {
      const Vec3 p(i & 1 ? 1 : 5, i & 2 ? 2 : 3, i & 4 ? 3 : 4);
      const Vec2 at = pixel(camera, p, 300, 200);
      widest = std::max({widest, std::abs(at.x() - 150) / 150, std::abs(at.y() - 100) / 100});
    }
    EXPECT_LT(widest, 1);
    EXPECT_GT(widest, 0.75);
  }
}

TEST_F(Live, AttachesShadowsToCasters) {
  const LiveScene scene = cube_scene();
  LiveOptions options = small();
  const Image with = draw(scene, from_above(), options);
  EXPECT_TRUE(m_view->work().shadow_map_drawn);
  options.shadows = false;
  const Image without = draw(scene, from_above(), options);
  keep(with, "shadow");
  // The light comes from -x: the shadow begins at the cube's right side.
  const LiveCamera camera = from_above();
  const Vec2 beside = pixel(camera, Vec3(1.12, 0.2, 0)), far = pixel(camera, Vec3(3, 0, 0));
  const Vec2 left = pixel(camera, Vec3(-1.12, 0, 0)), top = pixel(camera, Vec3(0, 0, 2));
  EXPECT_LT(brightness(with, beside), 0.8 * brightness(without, beside));
  EXPECT_NEAR(brightness(with, far), brightness(without, far), 2);
  EXPECT_NEAR(brightness(with, left), brightness(without, left), 2);
  EXPECT_NEAR(brightness(with, top), brightness(without, top), 2) << "no shadow on itself";
}

TEST_F(Live, KeepsMeshesAndShadowMap) {
  LiveScene scene = cube_scene();
  scene.objects.push_back(placed(scene.objects[0].model, Vec3(3, 0, 0)));
  const Image first = draw(scene, from_above());
  EXPECT_EQ(m_view->work().meshes_sent, 1);
  LiveCamera other = from_above();
  other.height = 12;
  draw(scene, other);
  EXPECT_EQ(m_view->work().meshes_sent, 0);
  EXPECT_FALSE(m_view->work().shadow_map_drawn);
  EXPECT_EQ(draw(scene, from_above()).rgba, first.rgba);
  scene.objects[1].world_from_object.translation.x() = 3.5;
  EXPECT_NE(draw(scene, from_above()).rgba, first.rgba);
  EXPECT_TRUE(m_view->work().shadow_map_drawn);
}

// A part that is cut away is as if it were not there; the section goes through the rest.
TEST_F(Live, CutsAwayWhatIsNearer) {
  LiveScene scene = cube_scene();
  scene.objects.push_back(placed(box_model(Vec3(-3, -2, 3), Vec3(3, 2, 3.2), kGrey)));
  LiveOptions options = small();
  options.shadows = false;
  const LiveScene without = cube_scene();
  for (const bool orthographic : {true, false})
    for (const bool draft : {false, true}) {
      options.draft = draft;
      LiveCamera camera = from_above();
      if (!orthographic) camera.height.reset();
      const Image open = draw(without, camera, options);
      EXPECT_GT(num_different(draw(scene, camera, options), open), 1000);
      camera.cut = 10 - 2.5;
      EXPECT_LT(num_different(draw(scene, camera, options), open), 20);
      camera.cut = 10 - 1;  // through the cube: its bottom is seen, and lines in front of it
      scene.overlay.add_loop({Vec3(-2, 0, 5), Vec3(2, 0, 5), Vec3(0, 0, 5)}, {1, 0, 0, 1}, 3,
                             Hidden::Shown);
      const Image half = draw(scene, camera, options);
      EXPECT_GT(num_different(half, open), 100);
      EXPECT_TRUE(has_colour(half, pixel(camera, Vec3(1.4, 0, 5)), {1, 0, 0, 1}, 90))
          << orthographic << draft;
      scene.overlay = {};
    }
}

TEST_F(Live, CullsObjectsOutOfSight) {
  LiveScene scene = cube_scene();
  for (int i = 0; i < 10; ++i)
    scene.objects.push_back(placed(scene.objects[0].model, Vec3(100 + 3 * i, 0, 0)));
  draw(scene, from_above());
  EXPECT_EQ(m_view->work().objects_drawn, 1);
  EXPECT_EQ(m_view->work().objects_culled, 10);
}

TEST_F(Live, OutlinesSelectedObjectsThroughOccluders) {
  LiveScene scene = cube_scene();
  LiveCamera camera;
  camera.eye = Vec3(0, -12, 1);
  camera.target = Vec3(0, 0, 1);
  camera.height = 6;
  // Behind the cube, and higher than it.
  scene.objects.push_back(placed(box_model(Vec3(-0.5, 3, 0), Vec3(0.5, 4, 3), kGrey)));
  const Image plain = draw(scene, camera);
  scene.objects[1].outlined = true;
  const LiveOptions options = small();
  const Image image = draw(scene, camera, options);
  keep(image, "outline");
  const auto side = [&](double x, double z) { return pixel(camera, Vec3(x, 3, z)); };
  EXPECT_TRUE(has_colour(image, side(-0.5, 2.5) + Vec2(-1, 0), options.theme.outline));
  EXPECT_TRUE(has_colour(image, side(0.5, 1.0) + Vec2(1, 0), options.theme.outline)) << "hidden";
  EXPECT_NEAR(brightness(image, side(0, 1)), brightness(plain, side(0, 1)), 1) << "inside";
  EXPECT_NEAR(brightness(image, side(-0.9, 1)), brightness(plain, side(-0.9, 1)), 1) << "outside";
}

// Data of earlier pictures must not be outlined.
TEST_F(Live, OutlinesIndependentlyOfEarlierPictures) {
  LiveScene large = cube_scene(), small_one = cube_scene();
  large.objects[0].outlined = true;
  small_one.objects = {placed(box_model(Vec3(-0.3, -0.3, 0), Vec3(0.3, 0.3, 1), kGrey))};
  small_one.objects[0].outlined = true;
  const Image fresh = draw(small_one, from_above());
  draw(large, from_above());
  EXPECT_EQ(draw(small_one, from_above()).rgba, fresh.rgba);
}

TEST_F(Live, ShowsBackgroundThroughGhosts) {
  LiveScene scene = cube_scene();
  const Image plain = draw(scene, from_above());
  LiveObject ghost = placed(scene.objects[0].model, Vec3(3.5, 0, 0));
  ghost.opacity = 0.4f;
  ghost.tint = {0.1f, 0.3f, 1.0f, 1.0f};
  scene.objects.push_back(ghost);
  const Image image = draw(scene, from_above());
  const std::uint8_t* p = image.pixel(120 + 70, 90);
  EXPECT_GT(p[2], p[0] + 20) << "bluish";
  EXPECT_GT(p[0], 60) << "the floor shows through";
  const Vec2 beside = pixel(from_above(), Vec3(4.7, 0, 0));
  EXPECT_NEAR(brightness(image, beside), brightness(plain, beside), 2) << "no shadow";
}

// A slab of 10 m, or a chequered one, of squares of 0.5 m.
LiveScene ground(const std::vector<float>& brightnesses) {
  LiveScene scene;
  const auto count = static_cast<int>(brightnesses.size());
  for (int i = 0; i < (count > 1 ? 400 : 1); ++i) {
    const double size = count > 1 ? 0.5 : 10;
    const Vec3 lower(-5 + size * (i % 20), -5 + size * (i / 20), -0.1);
    const float b = brightnesses[static_cast<size_t>((i % 20 + i / 20) % count)];
    scene.objects.push_back(placed(box_model(lower, lower + Vec3(size, size, 0.1), {b, b, b, 1})));
  }
  return scene;
}

// Largest difference of a channel within a pixel.
int contrast(const Image& a, const Image& b, const Vec2& at) {
  int out = 0;
  for (const int dx : {-1, 0, 1})
    for (const int dy : {-1, 0, 1})
      for (int c = 0; c < 3; ++c) {
        const int x = static_cast<int>(at.x()) + dx, y = static_cast<int>(at.y()) + dy;
        out = std::max(out, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
      }
  return out;
}

TEST_F(Live, OutlinesGhostsOnWhiteBlackAndChequeredGround) {
  for (const std::vector<float>& brightnesses : {std::vector<float>{1}, {0}, {1, 0}}) {
    LiveScene scene = ground(brightnesses);
    const Image plain = draw(scene, from_above());
    LiveObject ghost = placed(cube_scene().objects[0].model);
    ghost.opacity = 0.55f;
    ghost.outlined = true;
    ghost.tint = {0.1f, 0.3f, 1.0f, 1.0f};
    scene.objects.push_back(ghost);
    const Image image = draw(scene, from_above());
    int num_seen = 0;
    for (int i = 0; i < 40; ++i)
      for (const double side : {-1.0, 1.0})
        for (const Vec3& at : {Vec3(side, 0.05 * i - 1, 2), Vec3(0.05 * i - 1, side, 2)})
          num_seen += contrast(image, plain, pixel(from_above(), at)) >= 40;
    EXPECT_GE(num_seen, 150) << "of 160, ground " << brightnesses[0] << ", of "
                             << brightnesses.size();
  }
}

TEST_F(Live, ShowsBackgroundThroughTransparentMaterials) {
  LiveScene scene;
  scene.objects = {placed(box_model(Vec3(-1, -1, 0), Vec3(1, 1, 0.1), {1, 0, 0, 1})),
                   placed(box_model(Vec3(-2, -2, 1), Vec3(2, 2, 1.1), {0.2f, 0.2f, 1, 0.3f}))};
  const Image image = draw(scene, from_above());
  const std::uint8_t* p = image.pixel(120, 90);
  EXPECT_GT(p[0], 90);
  EXPECT_GT(p[0], p[1] + 30);
  EXPECT_GT(p[2], p[1] + 10);
}

TEST_F(Live, CutsFadesOrShowsOverlays) {
  LiveScene scene = cube_scene();
  const LiveColour red{1, 0, 0, 1};
  const LiveCamera camera = from_above();
  const Image plain = draw(scene, camera);
  const auto with_line = [&](Hidden hidden) {
    LiveScene lined = scene;  // from inside the cube to the floor beside it
    lined.overlay.lines = {{Vec3(0, 0, 1), Vec3(4, 0, 1), red, 3, hidden}};
    return draw(lined, camera);
  };
  const Vec2 hidden = pixel(camera, Vec3(0.5, 0, 1)), open = pixel(camera, Vec3(2.5, 0, 1));
  const Image cut = with_line(Hidden::Cut), faint = with_line(Hidden::Faint),
              shown = with_line(Hidden::Shown);
  for (const Image& image : {cut, faint, shown}) EXPECT_TRUE(has_colour(image, open, red, 12));
  EXPECT_TRUE(has_colour(shown, hidden, red, 12));
  EXPECT_FALSE(has_colour(faint, hidden, red));
  EXPECT_EQ(num_different(cut, plain, 10) < num_different(faint, plain, 10), true);
  EXPECT_NEAR(brightness(cut, hidden), brightness(plain, hidden), 1);
  EXPECT_FALSE(has_colour(shown, open + Vec2(0, 5), red)) << "3 pixels wide";
}

TEST_F(Live, DrawsOverlayPointsAndPolygons) {
  LiveScene scene;
  const LiveColour red{1, 0, 0, 1}, blue{0, 0, 1, 1};
  const LiveCamera camera = from_above();
  scene.overlay.points = {{Vec3(-2, 0, 0), blue, 6, Hidden::Cut}};
  scene.overlay.add_polygon({Vec3(1, -1, 0), Vec3(3, -1, 0), Vec3(3, 1, 0), Vec3(1, 1, 0)},
                            {1, 0, 0, 0.5f});
  scene.overlay.add_loop({Vec3(1, -1, 0), Vec3(3, -1, 0), Vec3(3, 1, 0), Vec3(1, 1, 0)}, red, 2);
  const Image image = draw(scene, camera);
  keep(image, "overlays");
  const Vec2 point = pixel(camera, Vec3(-2, 0, 0));
  EXPECT_TRUE(has_colour(image, point + Vec2(4, 0), blue, 12));
  EXPECT_FALSE(has_colour(image, point + Vec2(8, 0), blue));
  EXPECT_FALSE(has_colour(image, point + Vec2(6, 6), blue)) << "round";
  EXPECT_TRUE(has_colour(image, pixel(camera, Vec3(3, 0, 0)), red, 60)) << "its outline";
  const std::uint8_t* inside = image.pixel(120 + 40, 90);
  EXPECT_GT(inside[0], 200);
  EXPECT_NEAR(inside[1], 120, 40) << "the floor shines through by half";
}

TEST_F(Live, ClipsLinesBehindEye) {
  LiveScene scene;
  LiveCamera camera;
  camera.eye = Vec3(0, -2, 1);
  camera.target = Vec3(0, 0, 1);
  scene.overlay.lines = {{Vec3(0, -20, 0.5), Vec3(0, 20, 0.5), {1, 0, 0, 1}, 3, Hidden::Shown}};
  const Image image = draw(scene, camera);
  EXPECT_TRUE(has_colour(image, pixel(camera, Vec3(0, 5, 0.5)), {1, 0, 0, 1}, 12));
  EXPECT_TRUE(has_colour(image, Vec2(120, 178), {1, 0, 0, 1}, 12)) << "below the horizon";
  EXPECT_FALSE(has_colour(image, Vec2(120, 20), {1, 0, 0, 1})) << "above it";
}

TEST_F(Live, RefusesInvalidInput) {
  LiveOptions options = small();
  options.width = 0;
  EXPECT_THROW(draw(cube_scene(), from_above(), options), Error);
  LiveCamera camera = from_above();
  camera.height = -1;
  EXPECT_THROW(draw(cube_scene(), camera), Error);
  camera.height.reset();
  camera.eye = camera.target;
  EXPECT_THROW(draw(cube_scene(), camera), Error);
  LiveScene broken = cube_scene();
  broken.objects[0].world_from_object.translation.x() = std::nan("");
  EXPECT_NO_THROW(draw(broken, from_above())) << "an object with a non-finite pose is left out";
}

}  // namespace
}  // namespace trivet
