// Selection: by clicks beside thin things, through undo, past what is hidden.
#include "apps/edit/tools/picking.h"
#include "apps/edit_document/hand.h"

namespace trivet::edit::test {
namespace {

/// A fixed board with a thin rod on it, seen from above: 1 px is 1 mm.
class Selecting : public testing::Test {
 protected:
  Selecting() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("board.obj"), {{{-0.4, -0.3, 0}, {0.4, 0.3, 0.02}}});
    write_boxes(folder.file("rod.obj"), {{{-0.1, -0.001, 0}, {0.1, 0.001, 0.002}}});
    write_boxes(folder.file("box.obj"), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.05}}});
    document.import(folder.file("board.obj"), "board", true);
    put("rod", Vec3(0, 0, 0.03));
    put("box", Vec3(0.2, 0.2, 0.03));
    hand.view = View();
    hand.view.orthographic = true;
    hand.view.width_px = 1000, hand.view.height_px = 1000, hand.view.height = 1;
    hand.view.eye = Vec3(0, 0, 2), hand.view.target = Vec3::Zero(), hand.view.up = Vec3::UnitY();
    document->select({});
  }

  void put(const std::string& name, const Vec3& at) {
    document.import(folder.file(name + ".obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = at;
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
  }

  std::string click(const Vec2& at) {
    hand.click(at);
    const auto active = document->selection().active();
    return active ? (*document->snapshot()->find(*active))->name : "";
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Selecting, HitsThinThingsWithinAFewPixels) {
  const Vec2 rod = hand.px(Vec3(0.03, 0, 0.02));
  EXPECT_EQ(click(rod), "rod");
  EXPECT_EQ(click(rod + Vec2(0, 3)), "rod");
  EXPECT_EQ(click(rod - Vec2(0, 3)), "rod");
  EXPECT_EQ(click(rod + Vec2(0, 6)), "board");
}

TEST_F(Selecting, KeepsTheEdgesOfWideThings) {
  const Vec2 edge = hand.px(Vec3(0.15, 0.2, 0.07));
  EXPECT_EQ(click(edge + Vec2(2, 0)), "box");
  EXPECT_EQ(click(edge - Vec2(3, 0)), "board") << "the box is no thin thing";
  // There is only the floor next to the board.
  EXPECT_EQ(click(hand.px(Vec3(-0.4, 0, 0.02)) - Vec2(4, 0)), "board");
  EXPECT_EQ(click(hand.px(Vec3(-0.4, 0, 0.02)) - Vec2(12, 0)), "");
}

TEST_F(Selecting, GrabsTheSelectedObjectFirst) {
  toolbox.take(ToolKind::Push);
  const Vec2 beside = hand.px(Vec3(0.15, 0.2, 0.07)) - Vec2(4, 0);
  document->select_only(document.id("box"));
  hand.press(beside);
  EXPECT_EQ(document->selection().active(), document.id("box"));
  hand.release(beside);
  document->select_only(document.id("rod"));
  hand.press(beside);
  EXPECT_EQ(document->selection().active(), document.id("board"));
  hand.release(beside);
  document->wait_until_idle();
}

TEST_F(Selecting, UndoBringsBackTheSelection) {
  document->select({{document.id("rod"), document.id("box")}, {}});
  ASSERT_TRUE(hand.key(KeyEvent::Key::Delete));
  EXPECT_TRUE(document->selection().objects.empty());
  ASSERT_TRUE(document.done(document->undo()));
  const Selection both{{document.id("rod"), document.id("box")}, {}};
  EXPECT_EQ(document->selection(), both);
  // An object that is selected now and stays is kept.
  document->select_only(document.id("box"));
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(document->selection().active(), document.id("box"));
}

TEST_F(Selecting, PassesThroughWhatIsHiddenOrNotSelectable) {
  const Vec2 on_box = hand.px(Vec3(0.2, 0.2, 0.07)), on_board = hand.px(Vec3(-0.2, 0.2, 0.02));
  EXPECT_EQ(click(on_box), "box");
  Looks looks;
  looks.change(document.id("box"), {true, false, {}});
  looks.change(document.id("board"), {false, true, {}});
  document->set_looks(looks);
  EXPECT_TRUE(document->selection().objects.empty()) << "hidden objects are not selected";
  EXPECT_EQ(click(on_box), "");
  EXPECT_EQ(click(on_board), "");
  hand.drag(Vec2(1, 1), Vec2(999, 999), 3);
  EXPECT_EQ(document->selection().objects, std::vector{document.id("rod")});
  // PUT still puts on the board.
  toolbox.take(ToolKind::Put);
  hand.click(on_board);
  EXPECT_NEAR(document.object("rod").pose.translation.x(), -0.2, 0.01);
  document->set_looks({});
  toolbox.take(ToolKind::Select);
  EXPECT_EQ(click(on_box), "box");
}

TEST_F(Selecting, BoxTakesWhatIsSeenBehindTheSectionAlone) {
  View view = hand.view;
  const SceneSnapshot& scene = *document->snapshot();
  const Vec2 all(1000, 1000);
  EXPECT_EQ(pick_in_box(scene, view, Vec2::Zero(), all).size(), 3U);
  view.cut = view.depth(Vec3(0, 0, 0.021));  // through rod and box
  EXPECT_EQ(pick_in_box(scene, view, Vec2::Zero(), all).size(), 3U);
  view.cut = view.depth(Vec3(0, 0, 0.019));  // through the board
  EXPECT_EQ(pick_in_box(scene, view, Vec2::Zero(), all), std::vector{document.id("board")});
}

TEST_F(Selecting, ForgetsLooksWithTheScene) {
  Looks looks;
  looks.change(document.id("box"), {true, false, {}});
  document->set_looks(looks);
  ASSERT_TRUE(document.done(document->open_demo("spoon-saucer")));
  EXPECT_EQ(document->looks(), Looks());
  EXPECT_TRUE(document->selection().objects.empty());
}

TEST_F(Selecting, DoesNotLightWhatIsOnlyNamed) {
  toolbox.take(ToolKind::Push);
  const Vec2 on_board = hand.px(Vec3(-0.2, 0.2, 0.02));
  hand.drag(on_board, on_board + Vec2(40, 0));
  ASSERT_FALSE(document.messages().empty());
  EXPECT_EQ(document.messages().back().kind, Message::Kind::Refused);
  EXPECT_NE(document.last_text().find("fixed"), std::string::npos);
  EXPECT_TRUE(document.messages().back().objects.empty());
}

}  // namespace
}  // namespace trivet::edit::test
