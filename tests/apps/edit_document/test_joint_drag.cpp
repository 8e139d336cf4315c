// Drawers and doors dragged along their joints, in each of the views.
#include <cmath>
#include <fstream>

#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"
#include "core/scene/joint.h"

namespace trivet::edit::test {
namespace {

/// A cabinet with a drawer, open by 0.2 m with a cup in it, and a door at its side.
class JointDrag : public testing::Test {
 protected:
  JointDrag() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write("cabinet", {{{-0.2, -0.2, 0}, {-0.18, 0.2, 0.4}},
                      {{0.18, -0.2, 0}, {0.2, 0.2, 0.4}},
                      {{-0.18, -0.2, 0}, {0.18, 0.2, 0.02}},
                      {{-0.18, -0.2, 0.38}, {0.18, 0.2, 0.4}}});
    write("drawer", {{{-0.17, -0.17, 0.095}, {0.17, 0.17, 0.105}},
                     {{-0.175, -0.19, 0.095}, {0.175, -0.17, 0.205}}});
    write("door", {{{0, -0.005, 0.02}, {0.3, 0.005, 0.38}}});
    write("cup", {{{-0.03, -0.03, 0}, {0.03, 0.03, 0.06}}});
    write("box", {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.2}}});
    std::ofstream(folder.file("kitchen.json")) << R"({"trivet": 1, "objects": [
      {"name": "cabinet", "model": "cabinet.obj", "fixed": true, "position": [0, 0, 0.001]},
      {"name": "drawer", "model": "drawer.obj", "position": [0, 0, 0.001],
       "joint": {"in": "cabinet", "slide": [0, -1, 0], "lower": 0, "upper": 0.3}},
      {"name": "door", "model": "door.obj", "position": [0.21, -0.2, 0.001],
       "joint": {"in": "cabinet", "hinge": [0, 0, 1], "lower": 0, "upper": 80}},
      {"name": "cup", "model": "cup.obj"}, {"name": "box", "model": "box.obj"}],
      "operations": [{"op": "move_joint", "object": "drawer", "to": 0.2},
        {"op": "put", "object": "cup", "position": [0.05, -0.28, 0.3]},
        {"op": "put", "object": "box", "position": [0.1, -0.55, 0.3]}]})";
    if (!document.done(document->open(folder.file("kitchen.json"))))
      throw std::runtime_error(document.last_text());
    document->select({});
    steps = document->history().num_done;
  }

  void write(const std::string& name, const std::vector<Aabb>& boxes) {
    write_boxes(folder.file(name + ".obj"), boxes);
  }

  double value(const std::string& link) { return document.object(link).joint->value; }
  double cup() { return document.object("cup").pose.translation.y(); }
  void look_from(const Vec3& back, const Vec3& up, bool orthographic = true) {
    hand.view = View();
    hand.view.width_px = 1280, hand.view.height_px = 720;
    hand.view.target = Vec3(0, -0.2, 0.2);
    hand.view.eye = hand.view.target + 2 * back;
    hand.view.up = up;
    hand.view.orthographic = orthographic;
    hand.view.height = 1.2;
  }
  /// Presses there, and moves to a pixel in small steps.
  void pull(const Vec2& from, const Vec2& to) {
    hand.move(from);
    hand.press(from);
    for (int i = 1; i <= 6; ++i) {
      hand.move(from + (to - from) * i / 6);
      document->wait_until_idle();
    }
    end = to;
  }
  void let_go() {
    hand.release(end);
    document->wait_until_idle();
    EXPECT_EQ(wrong_with(*document->snapshot()), "");
  }
  size_t new_steps() const { return document->history().num_done - steps; }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  Vec2 end = Vec2::Zero();
  size_t steps = 0;
};

struct Seen {
  const char* name;
  Vec3 back, up;
  bool orthographic;
  Vec3 grabbed;
};

TEST_F(JointDrag, ADrawerFollowsTheMouseAlongItsAxis) {
  const Vec3 oblique = Vec3(0.5, -0.7, 0.6).normalized();
  for (const Seen& seen :
       {Seen{"perspective", oblique, Vec3::UnitZ(), false, {-0.1, -0.39, 0.151}},
        Seen{"from above", Vec3::UnitZ(), Vec3::UnitY(), true, {-0.1, -0.38, 0.206}},
        Seen{"from the side", Vec3::UnitX(), Vec3::UnitZ(), true, {0.175, -0.38, 0.15}}}) {
    SCOPED_TRACE(seen.name);
    look_from(seen.back, seen.up, seen.orthographic);
    const double before = cup();
    const Vec3 goal = seen.grabbed + Vec3(0, 0.13, 0);
    pull(hand.px(seen.grabbed), hand.px(goal));
    EXPECT_EQ(toolbox.reading(), "\"drawer\": 0.070 m");
    EXPECT_EQ(new_steps(), 0u) << "nothing is committed while the button is down";
    let_go();
    EXPECT_NEAR(value("drawer"), 0.07, 1e-3);
    EXPECT_NEAR(cup() - before, 0.2 - value("drawer"), 1e-9) << "the cup goes along";
    EXPECT_EQ(new_steps(), 1u) << document.last_text();
    EXPECT_EQ(document->history().steps.back(), "move joint \"drawer\"");
    EXPECT_EQ(document->selection().active(), document.id("drawer"));
    ASSERT_TRUE(document.done(document->undo()));
    EXPECT_EQ(value("drawer"), 0.2);
    EXPECT_EQ(cup(), before);
  }
}

// Seen along its axis a drawer has no length in the view: downwards comes towards the viewer.
TEST_F(JointDrag, ADrawerSeenFromTheFrontOpensDownwards) {
  look_from(-Vec3::UnitY(), Vec3::UnitZ());
  const Vec2 from = hand.px(Vec3(-0.1, -0.39, 0.15));
  const double metres = hand.view.metres_per_px(hand.view.depth(Vec3(-0.1, -0.39, 0.15)));
  pull(from, from - Vec2(0, 60));
  let_go();
  EXPECT_NEAR(value("drawer"), 0.2 - 60 * metres, 1e-3);
  ASSERT_TRUE(document.done(document->undo()));
  hand.view.eye = hand.view.target + 2 * Vec3::UnitY();
  pull(hand.px(Vec3(-0.1, 0.17, 0.1)), hand.px(Vec3(-0.1, 0.17, 0.1)) - Vec2(0, 60));
  EXPECT_GT(document.object("drawer").joint->value, 0.2) << "from behind it goes away upwards";
  let_go();
}

TEST_F(JointDrag, ADoorTurnsAboutItsHinge) {
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  const Vec3 hinge(0.21, -0.2, 0.381), grabbed(0.46, -0.2, 0.381);
  const double angle = 35 * 3.14159265358979 / 180;
  const Vec3 goal = hinge + 0.25 * Vec3(std::cos(angle), std::sin(angle), 0);
  pull(hand.px(grabbed), hand.px(goal));
  EXPECT_EQ(toolbox.reading(), "\"door\": 35.0°");
  let_go();
  EXPECT_NEAR(value("door"), 35, 0.2);
  ASSERT_TRUE(document.done(document->undo()));
  // From the front it turns across its axis; the far side of the limit is no place.
  look_from(-Vec3::UnitY(), Vec3::UnitZ());
  const Vec2 from = hand.px(Vec3(0.46, -0.205, 0.2));
  pull(from, from + Vec2(300, 0));
  EXPECT_EQ(toolbox.reading(), "\"door\": 80.0°; at its limit");
  let_go();
  EXPECT_EQ(value("door"), 80);
}

TEST_F(JointDrag, StepsAreThoseOfSnapping) {
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  hand.modifiers.control = true;
  const Vec3 grabbed(-0.1, -0.38, 0.206);
  pull(hand.px(grabbed), hand.px(grabbed + Vec3(0, 0.093, 0)));
  EXPECT_FALSE(toolbox.overlay(hand.view).note.empty());
  let_go();
  EXPECT_DOUBLE_EQ(value("drawer"), 0.1);
  pull(hand.px(Vec3(0.46, -0.2, 0.381)), hand.px(Vec3(0.45, -0.06, 0.381)));
  let_go();
  EXPECT_DOUBLE_EQ(value("door"), 30);
}

// The front is at y = -0.43 where the box is met.
TEST_F(JointDrag, ADrawerStopsAtTheFirstContact) {
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  const Vec3 grabbed(-0.1, -0.38, 0.206);
  pull(hand.px(grabbed), hand.px(grabbed - Vec3(0, 0.5, 0)));
  EXPECT_EQ(toolbox.reading(), "\"drawer\": 0.300 m; at its limit");
  let_go();
  ASSERT_TRUE(document.done(document->undo()));
  PutOperation put;
  put.object = "box", put.start.translation = Vec3(0.1, -0.48, 0.3);
  ASSERT_TRUE(document.done(document->perform(put))) << document.last_text();
  document.forget();
  pull(hand.px(grabbed), hand.px(grabbed - Vec3(0, 0.5, 0)));
  ASSERT_TRUE(document->snapshot()->drag);
  EXPECT_TRUE(document->snapshot()->drag->blocked);
  EXPECT_EQ(toolbox.cursor(), Cursor::Forbidden);
  EXPECT_EQ(toolbox.reading(), "\"drawer\": 0.240 m; stopped by \"box\"");
  let_go();
  EXPECT_NEAR(value("drawer"), 0.24, 1e-4);
  EXPECT_EQ(document.last_text(), "\"drawer\": 0.240 m; stopped by \"box\"");
}

TEST_F(JointDrag, EscapeLeavesItWhereItWas) {
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  const double before = cup();
  const Vec3 grabbed(-0.1, -0.38, 0.206);
  pull(hand.px(grabbed), hand.px(grabbed + Vec3(0, 0.1, 0)));
  EXPECT_NE(value("drawer"), 0.2) << "it follows live";
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  EXPECT_EQ(value("drawer"), 0.2);
  EXPECT_EQ(cup(), before);
  let_go();
  EXPECT_EQ(new_steps(), 0u);
  EXPECT_EQ(toolbox.reading(), "");
}

TEST_F(JointDrag, NumbersAreValuesOfTheJoint) {
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  toolbox.take(ToolKind::Push);
  const Vec3 grabbed(-0.1, -0.38, 0.206);
  pull(hand.px(grabbed), hand.px(grabbed + Vec3(0, 0.1, 0)));
  for (const char c : {'0', '.', '1', '2'}) EXPECT_TRUE(hand.key(c));
  EXPECT_NE(toolbox.reading().find("0.12 m"), std::string::npos) << toolbox.reading();
  hand.key(KeyEvent::Key::Return);
  EXPECT_EQ(value("drawer"), 0.12);
  EXPECT_EQ(new_steps(), 1u);
  let_go();
  EXPECT_EQ(new_steps(), 1u);
  // One beyond the limit ends there, and the message says so.
  const Vec3 nearer = grabbed + Vec3(0, 0.08, 0);
  pull(hand.px(nearer), hand.px(nearer + Vec3(0, 0.05, 0)));
  EXPECT_TRUE(hand.key('9'));
  hand.key(KeyEvent::Key::Return);
  EXPECT_EQ(value("drawer"), 0.3);
  EXPECT_EQ(document.last_text(), "\"drawer\": 0.300 m; at its limit");
  let_go();
}

TEST_F(JointDrag, ALockedDrawerStays) {
  LockOperation lock;
  lock.object = "drawer";
  if (!document.done(document->perform(lock))) GTEST_SKIP() << document.last_text();
  look_from(Vec3::UnitZ(), Vec3::UnitY());
  const Vec3 grabbed(-0.1, -0.38, 0.206);
  pull(hand.px(grabbed), hand.px(grabbed + Vec3(0, 0.1, 0)));
  EXPECT_FALSE(document->is_dragging());
  let_go();
  EXPECT_EQ(value("drawer"), 0.2);
}

}  // namespace
}  // namespace trivet::edit::test
