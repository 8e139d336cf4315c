// Numbers: typed during drags, and poses as numbers.
#include <cmath>

#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/tools/typed_numbers.h"
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"
#include "support/random_shapes.h"

namespace trivet::edit::test {
namespace {

void type(TypedNumbers& numbers, const std::string& text) {
  for (const char c : text)
    if (c == '\t')
      numbers.next_axis();
    else
      numbers.type(c);
}

TEST(TypedNumbers, ReadsWhatIsTyped) {
  const struct {
    std::string typed;
    std::vector<double> values;
  } cases[] = {{"0.3", {0.3, 0, 0}},
               {"-.5", {-0.5, 0, 0}},
               {"5-", {-5, 0, 0}},
               {"--2", {2, 0, 0}},
               {"1,25", {1.25, 0, 0}},
               {"1.2.3", {1.23, 0, 0}},
               {"0.3\t-1\t7", {0.3, -1, 7}},
               {"1\t\t\t2", {12, 0, 0}},
               {"-", {0, 0, 0}},
               {"", {0, 0, 0}}};
  for (const auto& [typed, values] : cases) {
    TypedNumbers numbers({"x", "y", "z"}, 0, " m");
    EXPECT_TRUE(numbers.empty());
    type(numbers, typed);
    EXPECT_EQ(numbers.values(), values) << typed;
    EXPECT_EQ(numbers.empty(), typed.empty()) << typed;
  }
}

TEST(TypedNumbers, ShowsAxesAndErases) {
  TypedNumbers numbers({"x", "y"}, 1, " m");
  type(numbers, "0.25");
  EXPECT_EQ(numbers.text(), "x 0 m  [y] 0.25 m");
  for (int i = 0; i < 9; ++i) numbers.erase();
  EXPECT_TRUE(numbers.empty());
  TypedNumbers degrees({""}, 0, "°");
  type(degrees, "-45");
  EXPECT_EQ(degrees.text(), "-45°");
  EXPECT_FALSE(TypedNumbers().takes_numbers());
}

TEST(PoseNumbers, RestoreTheRotation) {
  trivet::test::Random random(3);
  const auto check = [](const Rotation& r) {
    const Vec3 deg = angles_deg(r);
    EXPECT_LE(std::abs(deg.y()), 90);
    EXPECT_LT((rotation_by_angles(deg).matrix() - r.matrix()).norm(), 1e-7) << deg.transpose();
  };
  for (int i = 0; i < 2000; ++i) check(random.rotation());
  for (const double x : {-180.0, -90.0, 0.0, 45.0, 90.0, 180.0})
    for (const double y : {-90.0, -89.999999, 0.0, 90.0})
      for (const double z : {-180.0, 0.0, 30.0, 90.0, 270.0}) check(rotation_by_angles({x, y, z}));
}

TEST(PoseNumbers, TurnAboutOneAxisAsItSays) {
  for (const double deg : {0.0, 30.0, 90.0, 179.0, -120.0}) {
    EXPECT_NEAR(angles_deg(turned_about(Vec3::UnitZ(), deg)).z(), deg, 1e-9);
    EXPECT_NEAR(angles_deg(turned_about(Vec3::UnitX(), deg)).x(), deg, 1e-9);
  }
  const Vec3 east = turned_about(Vec3::UnitZ(), 90).matrix() * Vec3::UnitX();
  EXPECT_LT((east - Vec3::UnitY()).norm(), 1e-12);
}

TEST(PoseNumbers, KeepAllOtherDigits) {
  const Pose pose{Rotation{0.1, 0.2, 0.3, 0.4}.normalized(), {1.0 / 3, 2.0 / 3, 0.1}};
  const Pose moved = with_number(pose, PosePart::Position, 1, 0.5);
  EXPECT_EQ(moved.translation, Vec3(1.0 / 3, 0.5, 0.1));
  EXPECT_EQ(moved.rotation.matrix(), pose.rotation.matrix());
  const Pose turned = with_number(pose, PosePart::Rotation, 2, 12);
  EXPECT_EQ(turned.translation, pose.translation);
  EXPECT_NEAR(angles_deg(turned.rotation).z(), 12, 1e-9);
  EXPECT_NEAR(angles_deg(turned.rotation).x(), angles_deg(pose.rotation).x(), 1e-9);
}

/// Boxes on the floor, far from each other.
class Typing : public testing::Test {
 protected:
  Typing() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    const std::string file = folder.file("box.obj");
    write_boxes(file, {{{-0.1, -0.1, 0}, {0.1, 0.1, 0.2}}});
    document.import(file, "box");
    PutOperation put;
    put.object = "box";
    put.start.translation = Vec3(0, 0, 0.01);
    document.done(document->perform(put));
    hand.look_at({Vec3(-1, -1, 0), Vec3(1, 1, 1)});
    before = document.object("box").pose;
    num_steps = document->history().num_done;
  }

  /// Begins a drag of the box; then types.
  void drag_and_type(ToolKind tool, const std::string& typed) {
    toolbox.take(tool);
    at = *hand.seen("box");
    hand.press(at);
    hand.move(at + Vec2(9, 4));
    document->wait_until_idle();
    for (const char c : typed) c == '\t' ? hand.key(KeyEvent::Key::Tab) : hand.key(c);
  }
  Vec3 moved() { return document.object("box").pose.translation - before.translation; }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  Pose before;
  Vec2 at;
  size_t num_steps = 0;
};

TEST_F(Typing, MovesByExactlyTheNumbers) {
  drag_and_type(ToolKind::Move, "0.3\t-0.125\t.5");
  EXPECT_EQ(toolbox.reading().substr(0, 27), "x 0.3 m  y -0.125 m  [z] 0.") << toolbox.reading();
  hand.move(at + Vec2(80, 50));  // the mouse counts no longer
  EXPECT_TRUE(hand.key(KeyEvent::Key::Return));
  EXPECT_EQ(document->history().num_done, num_steps + 1);
  EXPECT_EQ(document.object("box").pose.translation, before.translation + Vec3(0.3, -0.125, 0.5));
  EXPECT_EQ(toolbox.reading(), "");
  hand.release(at);
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(moved(), Vec3::Zero());
}

TEST_F(Typing, PushesByTheNumbers) {
  drag_and_type(ToolKind::Push, "0.25\t0.5");
  hand.release(at);
  document->wait_until_idle();
  EXPECT_NEAR(moved().x(), 0.25, 1e-4) << document.last_text();
  EXPECT_NEAR(moved().y(), 0.5, 1e-4);
  EXPECT_EQ(document->history().num_done, num_steps + 1);
}

TEST_F(Typing, TurnsByTheDegrees) {
  drag_and_type(ToolKind::Turn, "45");
  EXPECT_TRUE(hand.key(KeyEvent::Key::Return));
  EXPECT_NEAR(std::abs(angles_deg(document.object("box").pose.rotation).z()), 45, 1e-6)
      << document.last_text();
  hand.release(at);
}

TEST_F(Typing, PicksUpByTheMetres) {
  drag_and_type(ToolKind::PickUp, "0.75");
  EXPECT_TRUE(hand.key(KeyEvent::Key::Return));
  EXPECT_NEAR(moved().z(), 0.75, 1e-6);  // along the contact's normal
  hand.release(at);
}

TEST_F(Typing, EscapeForgetsTheNumbers) {
  drag_and_type(ToolKind::Move, "3");
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  hand.release(at);
  EXPECT_EQ(moved(), Vec3::Zero());
  EXPECT_EQ(document->history().num_done, num_steps);
}

TEST_F(Typing, LeavesKeysAloneBetweenDrags) {
  toolbox.take(ToolKind::Move);
  KeyEvent one;
  one.character = '1';
  EXPECT_FALSE(toolbox.wants_key(one));
  drag_and_type(ToolKind::Move, "");
  EXPECT_TRUE(toolbox.wants_key(one));
  one.character = 'q';
  EXPECT_FALSE(toolbox.wants_key(one));
  hand.key(KeyEvent::Key::Escape);
}

}  // namespace
}  // namespace trivet::edit::test
