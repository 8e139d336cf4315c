// Live views of scenes whose look is known: shadows, outlines, ghosts, overlays, drafts.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "gpu/live_camera.h"
#include "gpu/live_view.h"
#include "ops/demo/demo.h"
#include "ops/layout/run.h"
#include "support/mesa_leaks.h"

namespace trivet {
namespace {

constexpr int kWidth = 240, kHeight = 180;

std::shared_ptr<const Model> box_model(const Vec3& lower, const Vec3& upper,
                                       const std::array<float, 4>& colour) {
  static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  auto model = std::make_shared<Model>();
  for (int i = 0; i < 8; ++i)
    model->mesh.vertices.push_back({i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                                    i & 4 ? upper.z() : lower.z()});
  for (const auto& s : kSides) {
    model->mesh.triangles.push_back({s[0], s[1], s[2]});
    model->mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  Material material;
  material.base_colour = colour;
  model->materials = {material};
  return model;
}

const std::array<float, 4> kGrey{0.5f, 0.5f, 0.5f, 1};

LiveObject placed(std::shared_ptr<const Model> model, const Vec3& at = Vec3::Zero()) {
  LiveObject object;
  object.model = std::move(model);
  object.world_from_object.translation = at;
  return object;
}

LiveScene cube_scene() {
  LiveScene scene;
  scene.objects = {placed(box_model(Vec3(-1, -1, 0), Vec3(1, 1, 2), kGrey))};
  return scene;
}

/// Straight down on the origin, 9 m high and 12 m wide; 20 pixels a metre; +x right, +y up.
LiveCamera from_above() {
  LiveCamera camera;
  camera.eye = Vec3(0, 0, 10);
  camera.target = Vec3::Zero();
  camera.up = Vec3::UnitY();
  camera.height = 9;
  return camera;
}

LiveOptions small() {
  LiveOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.theme = LiveTheme::light();
  options.theme.grid[3] = options.theme.axis_x[3] = options.theme.axis_y[3] = 0;
  return options;
}

double brightness(const Image& image, const Vec2& at) {
  const std::uint8_t* p = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
  return (p[0] + p[1] + p[2]) / 3.0;
}

Vec2 pixel(const LiveCamera& camera, const Vec3& world, double width = kWidth,
           double height = kHeight) {
  const ViewAxes axes = make_view_axes(camera, width / height);
  const Eigen::Vector4d p = clip_from_world(camera, axes, 0.1, 100) * world.homogeneous();
  return {0.5 * (p.x() / p.w() + 1) * width, 0.5 * (1 - p.y() / p.w()) * height};
}

int num_different(const Image& a, const Image& b, int by = 24) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    count += std::abs(a.rgba[i] - b.rgba[i]) > by || std::abs(a.rgba[i + 1] - b.rgba[i + 1]) > by ||
             std::abs(a.rgba[i + 2] - b.rgba[i + 2]) > by;
  return count;
}

/// Whether a pixel within 1 of there is of that colour.
bool has_colour(const Image& image, const Vec2& at, const LiveColour& colour, int tolerance = 40) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = static_cast<int>(at.x()) + dx, y = static_cast<int>(at.y()) + dy;
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      const std::uint8_t* p = image.pixel(x, y);
      bool same = true;
      for (int c = 0; c < 3; ++c) same = same && std::abs(p[c] - 255 * colour[c]) <= tolerance;
      if (same) return true;
    }
  return false;
}

class Live : public testing::Test {
 protected:
  void SetUp() override {
    try {
      m_context = std::make_unique<EglContext>();
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
    m_view = std::make_unique<LiveView>(*m_context);
  }
  Image draw(const LiveScene& scene, const LiveCamera& camera,
             const LiveOptions& options = small()) {
    return m_view->draw(scene, camera, options);
  }
  /// For people to look at, where TRIVET_PICTURES names a folder.
  static void keep(const Image& image, const std::string& name) {
    if (const char* folder = std::getenv("TRIVET_PICTURES"))
      write_png(image, std::string(folder) + "/" + name + ".png");
  }

  std::unique_ptr<EglContext> m_context;
  std::unique_ptr<LiveView> m_view;
};

TEST_F(Live, KnowsHowWideAPixelIs) {
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

TEST_F(Live, FramesABox) {
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

TEST_F(Live, ShadowsTouchWhatCastsThem) {
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

TEST_F(Live, KeepsMeshesAndTheShadowMap) {
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

TEST_F(Live, LeavesOutWhatIsOutOfSight) {
  LiveScene scene = cube_scene();
  for (int i = 0; i < 10; ++i)
    scene.objects.push_back(placed(scene.objects[0].model, Vec3(100 + 3 * i, 0, 0)));
  draw(scene, from_above());
  EXPECT_EQ(m_view->work().objects_drawn, 1);
  EXPECT_EQ(m_view->work().objects_culled, 10);
}

TEST_F(Live, OutlinesWhatIsSelectedThroughWhatHidesIt) {
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

// What is left of other pictures is not outlined.
TEST_F(Live, OutlinesDoNotDependOnEarlierPictures) {
  LiveScene large = cube_scene(), small_one = cube_scene();
  large.objects[0].outlined = true;
  small_one.objects = {placed(box_model(Vec3(-0.3, -0.3, 0), Vec3(0.3, 0.3, 1), kGrey))};
  small_one.objects[0].outlined = true;
  const Image fresh = draw(small_one, from_above());
  draw(large, from_above());
  EXPECT_EQ(draw(small_one, from_above()).rgba, fresh.rgba);
}

TEST_F(Live, GhostsShowWhatIsBehind) {
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

TEST_F(Live, SeeThroughMaterialsShowWhatIsBehind) {
  LiveScene scene;
  scene.objects = {placed(box_model(Vec3(-1, -1, 0), Vec3(1, 1, 0.1), {1, 0, 0, 1})),
                   placed(box_model(Vec3(-2, -2, 1), Vec3(2, 2, 1.1), {0.2f, 0.2f, 1, 0.3f}))};
  const Image image = draw(scene, from_above());
  const std::uint8_t* p = image.pixel(120, 90);
  EXPECT_GT(p[0], 90);
  EXPECT_GT(p[0], p[1] + 30);
  EXPECT_GT(p[2], p[1] + 10);
}

TEST_F(Live, OverlaysAreCutFaintOrShown) {
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

TEST_F(Live, OverlayPointsAndPolygons) {
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
  EXPECT_NEAR(inside[1], 120, 40) << "half of the floor is seen";
}

TEST_F(Live, LinesBehindTheEyeAreCut) {
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

TEST_F(Live, DraftsOfManyTrianglesDrawOnlyWhatMoves) {
  LiveScene scene = cube_scene();
  auto fine = std::make_shared<Model>(*scene.objects[0].model);
  const std::size_t enough = m_context->is_software() ? 10'000 : 500'000;
  while (fine->mesh.triangles.size() < enough)
    fine->mesh.triangles.insert(fine->mesh.triangles.end(),
                                scene.objects[0].model->mesh.triangles.begin(),
                                scene.objects[0].model->mesh.triangles.end());
  for (int i = 0; i < 11; ++i) {
    scene.objects.push_back(placed(fine, Vec3(-4 + 0.2 * i, 2.5, 0)));
    scene.objects.back().world_from_object.linear *= 0.05;
  }
  LiveOptions options = small();
  options.draft = true;
  scene.objects[0].moving = true;
  draw(scene, from_above(), options);
  EXPECT_FALSE(m_view->work().still_reused);
  EXPECT_TRUE(m_view->work().still_kept);
  scene.objects[0].world_from_object.translation.x() = 2;
  const Image draft = draw(scene, from_above(), options);
  EXPECT_TRUE(m_view->work().still_reused);
  EXPECT_FALSE(m_view->work().still_kept);
  options.draft = false;
  options.shadows = true;
  const Image full = draw(scene, from_above(), options);
  keep(draft, "draft"), keep(full, "full");
  // Smooth edges and the shadow of what moves are missing.
  const Vec2 at = pixel(from_above(), Vec3(2, 0, 2)),
             before = pixel(from_above(), Vec3(-0.5, 0, 0));
  EXPECT_NEAR(brightness(draft, at), brightness(full, at), 3);
  EXPECT_NEAR(brightness(draft, before), brightness(full, before), 3) << "gone from where it was";
}

/// A corner of the unit cube: its box has another one that it does not fill.
std::shared_ptr<const Model> cut_off_corner(std::size_t num_triangles) {
  auto model = std::make_shared<Model>();
  model->mesh.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  while (model->mesh.triangles.size() < num_triangles)
    for (const Index3& t : {Index3{0, 2, 1}, Index3{0, 1, 3}, Index3{0, 3, 2}, Index3{1, 2, 3}})
      model->mesh.triangles.push_back(t);
  Material material;
  material.base_colour = {0.8f, 0.1f, 0.1f, 1};
  model->materials = {material};
  return model;
}

// Four objects are drawn as they are: the outlined one and the three largest.
TEST_F(Live, DraftsFromAMovingCameraDrawSmallObjectsAsBoxes) {
  const std::size_t tenth = m_context->is_software() ? 10'001 : 500'001;
  LiveScene scene;
  for (int i = 0; i < 12; ++i) {
    scene.objects.push_back(placed(cut_off_corner(tenth), Vec3(-5 + 0.85 * i, 0, 0)));
    scene.objects[i].world_from_object.linear *= 0.4 + 0.02 * i;
  }
  scene.objects[0].outlined = true;
  const LiveCamera camera = from_above();
  const Image full = draw(scene, camera);
  LiveOptions options = small();
  options.draft = options.coarse = true;
  LiveCamera other = camera;
  other.eye += Vec3(3, 0, 0);
  draw(scene, other, options);
  EXPECT_EQ(m_view->work().objects_as_boxes, 8);
  const Image coarse = draw(scene, camera, options);
  keep(full, "corners_full"), keep(coarse, "corners_coarse");
  EXPECT_EQ(m_view->work().objects_as_boxes, 8);
  EXPECT_FALSE(m_view->work().shadow_map_drawn) << "nothing has moved but the camera";
  for (int i = 0; i < 12; ++i) {
    const Affine& pose = scene.objects[i].world_from_object;
    const Vec2 only_box = pixel(camera, pose.apply(Vec3(0.8, 0.8, 1))),
               both = pixel(camera, pose.apply(Vec3(0.2, 0.2, 0.6)));
    const std::uint8_t* p = coarse.pixel(int(only_box.x()), int(only_box.y()));
    EXPECT_EQ(p[0] > p[2] + 40, 1 <= i && i <= 8) << "a red box in place of object " << i;
    p = coarse.pixel(int(both.x()), int(both.y()));
    EXPECT_GT(p[0], p[2] + 40) << i;
  }
  const Image again = draw(scene, camera);
  EXPECT_FALSE(m_view->work().shadow_map_drawn);
  keep(again, "corners_again");
  EXPECT_EQ(num_different(again, full, 0), 0) << "nothing of the boxes is left";
  EXPECT_EQ(m_view->work().objects_as_boxes, 0);
  options.coarse = false;
  draw(scene, camera, options);
  EXPECT_EQ(m_view->work().objects_as_boxes, 0);
}

TEST_F(Live, RefusesWhatItCannotDraw) {
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
  EXPECT_NO_THROW(draw(broken, from_above())) << "an object that is nowhere is left out";
}

LiveScene demo_scene(const std::string& name) {
  const DemoLayout demo = make_demo(name);
  const LayoutRun run = run_layout(
      demo.layout, [&](const std::string& file, const Tessellation&) { return demo.model(file); },
      RunOptions{});
  LiveScene scene;
  for (const ObjectId id : run.scene.ids()) {
    const Object& object = run.scene.at(id);
    if (!object.placed) continue;
    LiveObject live;
    live.model = object.model;
    live.world_from_object = object.world_from_object();
    live.outlined = scene.objects.size() == 3;
    scene.objects.push_back(live);
  }
  return scene;
}

/// Wall clock, and of all processors together.
struct Milliseconds {
  double wall, processors;
};

Milliseconds milliseconds_per_picture(const std::function<void()>& draw, int times) {
  draw();
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t clock = std::clock();
  for (int i = 0; i < times; ++i) draw();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
  return {wall.count() / times, 1e3 * double(std::clock() - clock) / CLOCKS_PER_SEC / times};
}

TEST_F(Live, BreakfastAndAThousandObjects) {
  const LiveScene breakfast = demo_scene("breakfast");
  const DemoView from = make_demo("breakfast").view;
  LiveCamera camera;
  camera.eye = from.eye, camera.target = from.target, camera.fov_deg = from.fov_deg;
  LiveOptions options;
  options.width = 1280, options.height = 720;
  keep(draw(breakfast, camera, options), "breakfast_dark");
  options.theme = LiveTheme::light();
  keep(draw(breakfast, camera, options), "breakfast_light");
  options.draft = true;
  keep(draw(breakfast, camera, options), "breakfast_draft");
  options.draft = false;

  LiveScene thousand;  // 42 breakfasts
  for (int i = 0; i < 42; ++i)
    for (LiveObject object : breakfast.objects) {
      object.outlined = false;
      object.world_from_object.translation += Vec3(2.5 * (i % 7), 2.5 * (i / 7), 0);
      thousand.objects.push_back(object);
    }
  thousand.objects.back().moving = true;
  EXPECT_GE(thousand.objects.size(), 1000u);
  LiveCamera wide = camera;
  wide.target = Vec3(7.5, 6, 0), wide.eye = Vec3(13, -14, 9);
  keep(draw(thousand, wide, options), "thousand");
  EXPECT_EQ(m_view->work().objects_drawn + m_view->work().objects_culled,
            static_cast<int>(thousand.objects.size()));
  EXPECT_EQ(m_view->work().meshes_sent, 0) << "the models are those of the breakfast";

  const auto measure = [&](const char* name, LiveScene scene, LiveCamera view, bool drags,
                           bool draft, bool orbits = false) {
    options.draft = draft;
    const int times = m_context->is_software() ? 4 : 100;
    const Milliseconds ms = milliseconds_per_picture(
        [&] {
          if (drags) scene.objects.back().world_from_object.translation.z() += 1e-3;
          if (orbits) view.eye.x() += 1e-2;
          draw(scene, view, options);
        },
        times);
    std::printf("%-48s %8.2f ms, processors %8.2f ms (%s)\n", name, ms.wall, ms.processors,
                m_context->renderer().c_str());
    RecordProperty(name, std::to_string(ms.wall));
  };
  measure("breakfast, 1280x720, still scene", breakfast, camera, false, false);
  measure("breakfast, 1280x720, an object moves", breakfast, camera, true, false);
  measure("breakfast, 1280x720, dragged, draft", breakfast, camera, true, true);
  measure("1,000 objects, 1280x720, still scene", thousand, wide, false, false);
  measure("1,000 objects, 1280x720, an object moves", thousand, wide, true, false);
  measure("1,000 objects, 1280x720, dragged, draft", thousand, wide, true, true);
  measure("1,000 objects, 1280x720, camera moves, no boxes", thousand, wide, false, true, true);
  options.coarse = true;
  measure("1,000 objects, 1280x720, camera moves, draft", thousand, wide, false, true, true);
  keep(draw(thousand, wide, options), "thousand_coarse");
}

}  // namespace
}  // namespace trivet
