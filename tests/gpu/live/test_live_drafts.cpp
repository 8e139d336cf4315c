// Drafts during motion, and the cost of live views of the demos.
#include <chrono>
#include <ctime>
#include <functional>

#include "apps/demo/demo.h"
#include "live_stage.h"
#include "ops/files/layout/run.h"
#include "support/effort.h"

namespace trivet {
namespace {

using namespace test;

TEST_F(Live, DraftsOfManyTrianglesRedrawOnlyMovingObjects) {
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
  // Smooth edges and the shadow of the moving object are missing.
  const Vec2 at = pixel(from_above(), Vec3(2, 0, 2)),
             before = pixel(from_above(), Vec3(-0.5, 0, 0));
  EXPECT_NEAR(brightness(draft, at), brightness(full, at), 3);
  EXPECT_NEAR(brightness(draft, before), brightness(full, before), 3) << "gone from its old place";
}

/// A corner of the unit cube: it does not fill its box.
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

// Four objects are drawn in full: the outlined one and the three largest.
TEST_F(Live, DraftsFromMovingCameraDrawSmallObjectsAsBoxes) {
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
  EXPECT_FALSE(m_view->work().shadow_map_drawn) << "only the camera has moved";
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
  EXPECT_EQ(num_different(again, full, 0), 0) << "no trace of the boxes is left";
  EXPECT_EQ(m_view->work().objects_as_boxes, 0);
  options.coarse = false;
  draw(scene, camera, options);
  EXPECT_EQ(m_view->work().objects_as_boxes, 0);
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

/// Wall time, and processor time of all threads together.
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

TEST_F(Live, MeasuresBreakfastAndAThousandObjects) {
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

  if (with_effort(100) < 100) return;  // figures
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
