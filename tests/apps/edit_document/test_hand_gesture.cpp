// Objects moved by hand, without a tool: what they slide on, climb onto, hang back from, and that
// the ghost tells where they come to rest.
#include "apps/edit_document/hand_gestures.h"

namespace trivet::edit::test {
namespace {

TEST_F(HandGestures, SlideOnTheTableWithTheirLoads) {
  put("tray", "tray", -0.3, 0);
  put("cup", "cup", -0.25, 0, 0.03);
  const std::uint64_t before = fingerprint(*document->snapshot());
  const Vec3 tray = at("tray"), cup = at("cup");
  // The tray, beside the cup.
  from = hand.px(tray + Vec3(-0.08, 0, 0.01)), end = from + Vec2(260, 0);
  hand.press(from);
  for (int i = 1; i <= 8; ++i) move(from + (end - from) * i / 8);
  ASSERT_TRUE(document->ghost());
  EXPECT_TRUE(document->ghost()->ok) << document->ghost()->text;
  let_go();
  EXPECT_GT(at("tray").x() - tray.x(), 0.2);
  EXPECT_LT((at("tray") - tray - (at("cup") - cup)).norm(), 1e-6);
  EXPECT_EQ(new_steps(), 1u);
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
}

TEST_F(HandGestures, FollowTheMouseByTheirFoot) {
  put("box", "box", -0.3, 0);
  drag("box", Vec3(0.2, 0.1, top));
  EXPECT_NEAR(at("box").x(), 0.2, 0.005);
  EXPECT_NEAR(at("box").y(), 0.1, 0.005);
  EXPECT_EQ(new_steps(), 1u);
}

TEST_F(HandGestures, ClimbOntoWhatIsUnderTheMouse) {
  put("box", "box", 0.3, 0);
  put("cup", "cup", -0.3, 0);
  pull("cup", Vec3(0.3, 0, top + 0.1));
  ASSERT_TRUE(document->ghost());
  EXPECT_TRUE(document->ghost()->ok) << document->ghost()->text;
  let_go();
  EXPECT_NEAR(box("cup").lower.z(), top + 0.1, kSlack);
  EXPECT_NEAR(at("cup").x(), 0.3, 0.005);
  EXPECT_EQ(new_steps(), 1u);
  // And down again.
  drag("cup", Vec3(0, 0, top));
  EXPECT_NEAR(box("cup").lower.z(), top, kSlack);
  // Between the rims of a tray.
  put("tray", "tray", -0.4, -0.1);
  drag("cup", Vec3(-0.4, -0.1, top + 0.01));
  EXPECT_NEAR(box("cup").lower.z(), top + 0.01, kSlack);
}

// A mouse over the side of what stands on another level means the place beside it.
TEST_F(HandGestures, GoBesideWhatStandsOnAnotherLevel) {
  write("stage", {{{-0.2, -0.2, 0}, {0.2, 0.2, 0.1}}});
  put("stage", "stage", 0.3, 0);
  put("box", "box", 0.3, 0, 0.11);
  put("cup", "cup", -0.3, -0.1);
  hand.view.eye = Vec3(-1.6, 0, 1.2), hand.view.target = Vec3(0, 0, 0.05);
  pull("cup", Vec3(0.25, 0, top + 0.13));  // the side of the box
  let_go();
  EXPECT_NEAR(box("cup").lower.z(), top + 0.1, kSlack);
  EXPECT_LT(box("cup").upper.x(), 0.25);
  EXPECT_EQ(new_steps(), 1u);
}

TEST_F(HandGestures, HangBackWhereTheyAreBlocked) {
  write("wall", {{{-0.02, -0.2, 0}, {0.02, 0.2, 0.4}}});
  put("wall", "wall", 0.2, 0);
  ASSERT_TRUE(document.done(document->perform(FixOperation{"wall", true})));
  put("cup", "cup", 0, 0);
  // The foot is over the side of the wall, which faces the cup.
  hand.view.eye = Vec3(-1.6, 0, 1.2), hand.view.target = Vec3(0, 0, 0.05);
  drag("cup", Vec3(0.18, 0, top + 0.1));
  EXPECT_LT(box("cup").upper.x(), 0.18);
  EXPECT_GT(box("cup").upper.x(), 0.17);
  EXPECT_NEAR(box("cup").lower.z(), top, kSlack);
  EXPECT_EQ(new_steps(), 1u);
}

// A mouse on the side of something, with another thing in the way: it is put beside it.
TEST_F(HandGestures, GoBesideAWallBeyondWhatBlocksThem) {
  write("wall", {{{-0.02, -0.2, 0}, {0.02, 0.2, 0.4}}});
  put("wall", "wall", 0.4, 0);
  ASSERT_TRUE(document.done(document->perform(FixOperation{"wall", true})));
  put("box", "box", 0, 0);
  put("cup", "cup", -0.3, 0);
  hand.view.eye = Vec3(-1.6, 0, 1.2), hand.view.target = Vec3(0, 0, 0.05);
  drag("cup", Vec3(0.38, 0, top + 0.1));
  EXPECT_LT(box("cup").upper.x(), 0.38);
  EXPECT_GT(box("cup").upper.x(), 0.35);
  EXPECT_NEAR(box("cup").lower.z(), top, kSlack);
  EXPECT_EQ(new_steps(), 1u);
}

// The rim of a dish hangs over the place, by less than a tenth of the cup.
TEST_F(HandGestures, GoUnderALip) {
  write("dish", {{{-0.1, -0.1, 0}, {0.1, 0.1, 0.004}}, {{-0.1, 0.02, 0.006}, {0.1, 0.1, 0.008}}});
  put("dish", "dish", 0, 0);
  put("cup", "cup", -0.4, 0);
  hand.view.eye = Vec3(0, -1.6, 0.05), hand.view.target = Vec3(0, 0, 0.02);
  drag("cup", Vec3(0, 0.03, top + 0.004));
  EXPECT_NEAR(at("cup").y(), 0.03, 0.01);
  EXPECT_NEAR(box("cup").lower.z(), top + 0.008, kSlack / 2);
}

TEST_F(HandGestures, GoBeyondWhatBlocksThem) {
  for (const double y : {-0.11, 0.0, 0.11}) put("box", "box" + std::to_string(y), 0.1, y);
  put("cup", "cup", -0.3, 0);
  const Vec3 row = at("box" + std::to_string(0.0));
  drag("cup", Vec3(0.4, 0, top));
  EXPECT_NEAR(at("cup").x(), 0.4, 0.005);
  EXPECT_NEAR(box("cup").lower.z(), top, kSlack);
  EXPECT_EQ(at("box" + std::to_string(0.0)), row);
  EXPECT_EQ(new_steps(), 1u);
}

TEST_F(HandGestures, TurnByTheWheelAndLieByAKey) {
  put("book", "book", -0.3, 0);
  pull("book", Vec3(0.1, 0, top));
  hand.wheel(end, 6);  // by 90 degrees
  ASSERT_TRUE(document->ghost());
  EXPECT_TRUE(document->ghost()->ok) << document->ghost()->text;
  let_go();
  EXPECT_NEAR(box("book").upper.x() - box("book").lower.x(), 0.16, kSlack);
  EXPECT_EQ(new_steps(), 1u);
  pull("book", Vec3(0.2, 0.1, top));
  hand.key('l');
  let_go();
  EXPECT_LT(box("book").upper.z(), top + 0.17) << "it stands as before";
  EXPECT_EQ(document.object("book").state, ObjectState::Stable);
  EXPECT_EQ(new_steps(), 2u);
}

TEST_F(HandGestures, GoThroughAllWaysToLie) {
  put("book", "book", 0, 0);
  const std::vector<WayToLie> ways = ways_to_lie(document.object("book"));
  ASSERT_EQ(ways.size(), 6u);
  EXPECT_LT(ways[0].turn_deg, 0.1);
  EXPECT_NEAR(ways[1].turn_deg, 90, 0.1);
  EXPECT_NEAR(ways[5].turn_deg, 180, 0.1);
  const auto side = way_of(ways, Lying::OnItsSide);
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->tilt_deg, 90, 0.1);
  EXPECT_FALSE(way_of(ways, Lying::Upright)) << "it stands";
  // After the last one it stands again.
  pull("book", Vec3(0.02, 0, top));
  for (int i = 0; i < 6; ++i) hand.key('l');
  let_go();
  EXPECT_NEAR(box("book").upper.z(), top + 0.2, kSlack);
}

TEST_F(HandGestures, LiftWithShift) {
  document.import(folder.file("box.obj"), "low");
  put("box", "box", 0.3, 0);
  put("cup", "cup", 0, 0);
  pull("cup", Vec3(0.05, 0, top));
  hand.modifiers.shift = true;
  end -= Vec2(0, 60);
  move(end);
  ASSERT_TRUE(document->ghost());
  const auto* const put = std::get_if<PutOperation>(&document->ghost()->operation);
  ASSERT_TRUE(put);
  EXPECT_GT(put->start.translation.z(), top + 0.05);
  hand.modifiers.shift = false;
  let_go();
  EXPECT_NEAR(box("cup").lower.z(), top, kSlack) << "it settles";
  EXPECT_NEAR(at("cup").x(), 0.05, 0.005);
}

TEST_F(HandGestures, SnapToTheGridWithControl) {
  put("cup", "cup", 0, 0);
  hand.modifiers.control = true;
  toolbox.options().snap.grid_step = 0.1;
  toolbox.options().snap.corners = toolbox.options().snap.edges = false;
  drag("cup", Vec3(0.23, 0.06, top));
  EXPECT_NEAR(at("cup").x(), 0.2, 1e-3);
  EXPECT_NEAR(at("cup").y(), 0.1, 1e-3);
}

TEST_F(HandGestures, GiveBackByEscape) {
  put("box", "box", 0.3, 0);
  put("cup", "cup", -0.3, 0);
  const std::uint64_t before = fingerprint(*document->snapshot());
  for (const Vec3& to : {Vec3(0, 0, top), Vec3(0.3, 0, top + 0.1)}) {
    pull("cup", to);
    EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
    hand.release(end);
    document->wait_until_idle();
    EXPECT_EQ(fingerprint(*document->snapshot()), before);
    EXPECT_EQ(new_steps(), 0u);
    EXPECT_FALSE(document->ghost());
  }
}

TEST_F(HandGestures, AreNoStepWhereNothingMoved) {
  put("cup", "cup", 0, 0);
  const std::uint64_t before = fingerprint(*document->snapshot());
  pull("cup", Vec3(0.05, 0, top));
  hand.wheel(end, 1);
  hand.wheel(end, -1);
  for (int i = 1; i <= 4; ++i) move(end + (from - end) * i / 4);
  end = from;
  let_go();
  EXPECT_EQ(new_steps(), 0u);
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
}

TEST_F(HandGestures, DrawABoxFromWhatIsFixed) {
  put("box", "box", 0.1, 0);
  put("cup", "cup", -0.1, 0);
  const auto all = [&] {
    return std::pair(hand.px(Vec3(-0.55, -0.35, top)), hand.px(Vec3(0.5, 0.35, top + 0.15)));
  };
  const auto [a, b] = all();
  hand.drag(a, b, 3);
  EXPECT_EQ(document->selection().objects, (std::vector{document.id("box"), document.id("cup")}));
  EXPECT_EQ(new_steps(), 0u);
  // A corner of the box alone is not it.
  hand.drag(a, hand.px(box("box").centre() - Vec3(0.04, 0, 0)), 3);
  EXPECT_EQ(document->selection().objects, std::vector{document.id("cup")});
  // Fixed things where there is nothing else.
  hand.drag(Vec2(2, 2), Vec2(1278, 718), 3);
  EXPECT_EQ(document->selection().objects.size(), 2u);
  // From an object with Shift and Control.
  document->select({});
  hand.modifiers.shift = hand.modifiers.control = true;
  hand.drag(hand.px(box("cup").centre()), hand.px(Vec3(0.2, 0.1, top + 0.1)), 3);
  EXPECT_EQ(document->selection().objects, std::vector{document.id("box")});
  EXPECT_EQ(new_steps(), 0u);
}

}  // namespace
}  // namespace trivet::edit::test
