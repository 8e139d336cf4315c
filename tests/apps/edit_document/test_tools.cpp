// Tools driven by synthetic events: SPOON-SAUCER from an empty scene, and picking.
#include <cmath>

#include "apps/edit/tools/constraint_camera.h"
#include "apps/edit/tools/picking.h"
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

class Tools : public testing::Test {
 protected:
  Tools() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {}

  void import(const std::string& name) {
    ImportModel model;
    model.file = folder.file(name + ".glb");
    model.name = name;
    for (const char* extension : {".glb", ".obj", ".ply", ".stl"})
      if (std::filesystem::exists(folder.file(name + extension)))
        model.file = folder.file(name + extension);
    ASSERT_TRUE(document.done(document->import_model(model))) << document.last_text();
  }

  void expect_sound() { EXPECT_EQ(wrong_with(*document->snapshot()), ""); }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Tools, LayOutSpoonSaucerFromEmptyScene) {
  ASSERT_TRUE(document->wait_until_idle());
  const std::uint64_t empty = fingerprint(*document->snapshot());
  write_models("spoon-saucer", folder);
  import("saucer");
  EXPECT_EQ(document->selection().active(), document.id("saucer"));
  hand.look_at({Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.02)});

  // PUT: the ghost follows the mouse, a click puts the object down.
  toolbox.take(ToolKind::Put);
  hand.move(hand.px(Vec3(0, 0, 0)));
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_TRUE(document->ghost());
  EXPECT_TRUE(document->ghost()->ok) << document->ghost()->text;
  const Pose ghost = document->ghost()->members.at(0).pose;
  hand.click(hand.px(Vec3(0, 0, 0)));
  ASSERT_EQ(document.object("saucer").state, ObjectState::Stable) << document.last_text();
  EXPECT_EQ(document.object("saucer").pose.translation, ghost.translation);
  expect_sound();

  import("spoon");
  hand.click(hand.px(Vec3(0.036, 0.014, 0.01)));
  ASSERT_EQ(document.object("spoon").state, ObjectState::Stable) << document.last_text();
  expect_sound();

  // PUSH over the curved surface.
  toolbox.take(ToolKind::Push);
  const Vec3 before = document.object("spoon").pose.translation;
  const auto at = hand.seen("spoon");
  ASSERT_TRUE(at);
  hand.drag(*at, *at + Vec2(-60, 10), 20);
  const Vec3 pushed = document.object("spoon").pose.translation;
  EXPECT_GT((pushed - before).head<2>().norm(), 0.003) << document.last_text();
  EXPECT_EQ(document->history().steps.back(), "push \"spoon\"");
  EXPECT_GE(document->drag_milliseconds().size(), 15u);
  expect_sound();

  // TURN about an edge of a contact.
  const size_t steps = document->history().num_done;
  toolbox.take(ToolKind::Turn);
  document->select_only(document.id("saucer"));
  const Object& saucer = document.object("saucer");
  ASSERT_FALSE(saucer.contacts.empty());
  const std::vector<Vec3>& hull = saucer.contacts[0].contact.hull;
  ASSERT_GE(hull.size(), 3u);
  const Vec3 middle = 0.5 * (hull[0] + hull[1]);
  const Vec3 room = Vec3::Constant((hull[1] - hull[0]).norm());
  hand.look_down({middle - room, middle + room});
  hand.click(hand.px(middle));
  ASSERT_TRUE(document->selection().contact);
  EXPECT_EQ(document->selection().contact->part, ActiveContact::Part::Edge);
  // Outwards: over the edge.
  const Vec3 outwards = (middle - saucer.centre_of_mass()).cwiseProduct(Vec3(1, 1, 0));
  const Vec2 way = 24 * (hand.px(middle + outwards) - hand.px(middle)).normalized();
  hand.drag(hand.px(middle), hand.px(middle) + way, 6);
  EXPECT_EQ(document->history().num_done, steps + 1) << document.last_text();
  EXPECT_EQ(document.object("saucer").state, ObjectState::Held);
  expect_sound();
  ASSERT_TRUE(document.done(document->undo()));

  // PICK-UP, then move the object around.
  hand.look_at({Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.02)});
  toolbox.take(ToolKind::PickUp);
  toolbox.options().pick_up_distance = 0.05;
  hand.click(*hand.seen("spoon"));
  EXPECT_EQ(document.object("spoon").state, ObjectState::Held) << document.last_text();
  EXPECT_GT(document.object("spoon").pose.translation.z(), pushed.z() + 0.04);
  toolbox.take(ToolKind::Move);
  const auto held = hand.seen("spoon");
  ASSERT_TRUE(held);
  hand.drag(*held, *held + Vec2(40, -20), 8);
  ASSERT_TRUE(document->snapshot()->find("spoon"));
  EXPECT_EQ(document->history().steps[document->history().num_done - 1], "move \"spoon\"");
  expect_sound();

  // Undo all, and redo it all.
  const std::uint64_t end = fingerprint(*document->snapshot());
  const size_t all = document->history().num_done;
  ASSERT_TRUE(document.done(document->go_to_step(0)));
  EXPECT_EQ(fingerprint(*document->snapshot()), empty);
  ASSERT_TRUE(document.done(document->go_to_step(all - 2)));
  const Vec3 saved = document.object("spoon").pose.translation;
  ASSERT_TRUE(document.done(document->save_as(folder.file("scene.glb")))) << document.last_text();
  ASSERT_TRUE(document.done(document->go_to_step(all)));
  EXPECT_EQ(fingerprint(*document->snapshot()), end);
  ASSERT_TRUE(document.done(document->open(folder.file("scene.glb")))) << document.last_text();
  EXPECT_EQ(document->snapshot()->objects.size(), 2u);
  EXPECT_EQ(document.object("spoon").pose.translation, saved);
  expect_sound();
}

TEST_F(Tools, EscapeCancelsDrag) {
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  hand.look_at(document->snapshot()->box());
  toolbox.take(ToolKind::Push);
  const std::uint64_t before = fingerprint(*document->snapshot());
  const auto at = hand.seen("spoon");
  ASSERT_TRUE(at);
  hand.press(*at);
  hand.move(*at + Vec2(20, 5));
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_TRUE(document->snapshot()->drag);
  EXPECT_NE(fingerprint(*document->snapshot()), before);
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  EXPECT_FALSE(document->snapshot()->drag);
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
  hand.release(*at);
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_EQ(document->history().num_done, 0u);
}

TEST_F(Tools, SelectByClickShiftClickAndBox) {
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  hand.look_at(document->snapshot()->box());
  hand.click(*hand.seen("spoon"));
  EXPECT_EQ(document->selection().objects, std::vector{document.id("spoon")});
  hand.modifiers.shift = true;
  hand.click(*hand.seen("saucer"));
  EXPECT_EQ(document->selection().objects.size(), 2u);
  EXPECT_EQ(document->selection().active(), document.id("saucer"));
  hand.modifiers.shift = false;
  hand.click(Vec2(2, 2));
  EXPECT_TRUE(document->selection().objects.empty());
  hand.drag(Vec2(2, 2), Vec2(1278, 718), 3);
  EXPECT_EQ(document->selection().objects.size(), 2u);
  EXPECT_TRUE(hand.key(KeyEvent::Key::Delete));
  EXPECT_TRUE(document->snapshot()->objects.empty());
  EXPECT_EQ(document->history().steps, std::vector<std::string>{"delete 2 objects"});
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document->snapshot()->objects.size(), 2u);
}

TEST(View, InvertsProjectionByRays) {
  for (const bool orthographic : {false, true}) {
    View view;
    view.eye = Vec3(1, -3, 2);
    view.target = Vec3(0.2, 0, 0.1);
    view.orthographic = orthographic;
    view.width_px = 640;
    view.height_px = 480;
    for (const Vec2& px : {Vec2(0, 0), Vec2(320, 240), Vec2(600, 17)}) {
      const Ray ray = view.ray(px);
      EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
      const auto back = view.project(ray.at(2.5));
      ASSERT_TRUE(back);
      EXPECT_NEAR((*back - px).norm(), 0, 1e-9);
    }
    EXPECT_NEAR((view.ray(Vec2(320, 240)).direction - view.forward()).norm(), 0, 1e-12);
  }
}

TEST_F(Tools, ConstraintWindowLooksAlongNormalAndHeldEdge) {
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  Selection selection{{document.id("saucer")}, std::nullopt};
  const SceneSnapshot& scene = *document->snapshot();
  const View along = constraint_view(scene, selection, std::nullopt, 640, 480);
  EXPECT_TRUE(along.orthographic);
  EXPECT_NEAR(along.forward().z(), -1, 1e-6);
  const std::vector<Vec3>& hull = document.object("saucer").contacts[0].contact.hull;
  selection.contact = ActiveContact{document.object("saucer").contacts[0].with,
                                    ActiveContact::Part::Edge, 0.5 * (hull[0] + hull[1])};
  const View edge = constraint_view(scene, selection, std::nullopt, 640, 480);
  EXPECT_NEAR(std::abs(edge.forward().dot((hull[1] - hull[0]).normalized())), 1, 1e-9);
  const View axis = constraint_view(scene, selection, Vec3(0, 2, 0), 640, 480);
  EXPECT_NEAR(std::abs(axis.forward().y()), 1, 1e-12);
  // The object is visible in the picture.
  for (const View& view : {along, edge, axis}) {
    const auto at = view.project(document.object("saucer").centre_of_mass());
    ASSERT_TRUE(at);
    EXPECT_NEAR((*at - Vec2(320, 240)).norm(), 0, 60);
  }
}

}  // namespace
}  // namespace trivet::edit::test
