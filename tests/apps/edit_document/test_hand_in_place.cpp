// Objects turned and laid otherwise where they are: lifted, turned, settled; and leaning.
#include "apps/edit/tools/picking.h"
#include "apps/edit_document/hand_gestures.h"

namespace trivet::edit::test {
namespace {

TEST_F(HandGestures, LieOnTheirSideAndStandUp) {
  put("book", "book", 0.1, 0.05);
  document->select_only(document.id("book"));
  ASSERT_TRUE(toolbox.lie(Lying::OnItsSide));
  document->wait_until_idle();
  EXPECT_NEAR(box("book").upper.z(), top + 0.04, kSlack);
  EXPECT_EQ(new_steps(), 1u);
  EXPECT_EQ(document.object("book").state, ObjectState::Stable);
  ASSERT_TRUE(toolbox.lie(Lying::Upright));
  document->wait_until_idle();
  EXPECT_NEAR(box("book").upper.z(), top + 0.2, kSlack);
  EXPECT_EQ(new_steps(), 2u);
  // Once more: there is nothing to do, and it is told.
  document.forget();
  ASSERT_TRUE(toolbox.lie(Lying::Upright));
  document->wait_until_idle();
  EXPECT_EQ(new_steps(), 2u);
  ASSERT_EQ(document.messages().size(), 1u);
  EXPECT_EQ(document.messages()[0].kind, Message::Kind::Info);
}

TEST_F(HandGestures, TurnInPlaceByAKey) {
  put("book", "book", 0.1, 0.05);
  document->select_only(document.id("book"));
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(hand.key(','));
  EXPECT_NEAR(box("book").upper.x() - box("book").lower.x(), 0.16, kSlack);
  EXPECT_NEAR(box("book").centre().x(), 0.1, kSlack);
  EXPECT_EQ(new_steps(), 6u);
  EXPECT_TRUE(hand.key('l'));
  EXPECT_LT(box("book").upper.z(), top + 0.17);
}

TEST_F(HandGestures, AreLiftedToBeTurnedByARing) {
  put("book", "book", 0, 0);
  document->select_only(document.id("book"));
  toolbox.take(ToolKind::Rotate);
  const Vec3 centre = document.object("book").centre_of_mass();
  // The ring about y, which faces the view, at its right end; up by a quarter turn.
  hand.view.eye = Vec3(0, -1.6, centre.z()), hand.view.target = centre;
  const Vec2 middle = hand.px(centre);
  from = middle + Vec2(72, 0), end = middle + Vec2(0, -72);
  hand.move(from);
  hand.press(from);
  for (int i = 1; i <= 8; ++i) {
    const double angle = i * M_PI / 16;
    move(middle + 72 * Vec2(std::cos(angle), -std::sin(angle)));
  }
  ASSERT_TRUE(document->ghost());
  EXPECT_TRUE(document->ghost()->ok) << document->ghost()->text;
  let_go();
  EXPECT_EQ(new_steps(), 1u);
  EXPECT_NEAR(box("book").upper.z(), top + 0.04, kSlack) << "it lies";
}

TEST_F(HandGestures, PutTurnsByTheWheel) {
  document.import(folder.file("book.obj"), "book");
  toolbox.take(ToolKind::Put);
  document->select_only(document.id("book"));
  steps = document->history().num_done;
  const Vec2 there = hand.px(Vec3(0.1, 0, top));
  move(there);
  hand.wheel(there, 6);
  hand.click(there);
  EXPECT_NEAR(box("book").upper.x() - box("book").lower.x(), 0.16, kSlack);
  EXPECT_EQ(new_steps(), 1u);
}

TEST_F(HandGestures, LeanAgainstAWall) {
  write("wall", {{{-0.02, -0.2, 0}, {0.02, 0.2, 0.4}}});
  put("wall", "wall", 0.2, 0);
  ASSERT_TRUE(document.done(document->perform(FixOperation{"wall", true})));
  put("book", "book", 0.1, 0);
  EXPECT_FALSE(toolbox.lean()) << "there is nothing to lean on";
  Selection both;
  both.objects = {document.id("book"), document.id("wall")};
  document->select(both);
  ASSERT_TRUE(toolbox.lean());
  document->wait_until_idle();
  EXPECT_EQ(new_steps(), 1u) << document.last_text();
  EXPECT_EQ(document.object("book").state, ObjectState::Stable);
  EXPECT_TRUE(leans(document.object("book")));
  EXPECT_NEAR(box("book").upper.x(), 0.18, kSlack);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(HandGestures, LeanAgainstTheSideOfTheirShelf) {
  write("shelf", {{{-0.3, -0.1, 0}, {0.3, 0.1, 0.02}},
                  {{-0.3, -0.1, 0.02}, {-0.28, 0.1, 0.3}},
                  {{0.28, -0.1, 0.02}, {0.3, 0.1, 0.3}}});
  put("shelf", "shelf", 0, 0);
  ASSERT_TRUE(document.done(document->perform(FixOperation{"shelf", true})));
  std::string against = "shelf";
  for (const double x : {0.2, 0.12, 0.04}) {
    const std::string name = "book" + std::to_string(x);
    put("book", name, x, 0, 0.03);
    Selection both;
    both.objects = {document.id(name), document.id(against)};
    document->select(both);
    ASSERT_TRUE(toolbox.lean());
    document->wait_until_idle();
    EXPECT_EQ(new_steps(), 1u) << document.last_text();
    EXPECT_EQ(document.object(name).state, ObjectState::Stable);
    EXPECT_TRUE(leans(document.object(name))) << "to the nearest side, each against the one before";
    against = name;
  }
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

}  // namespace
}  // namespace trivet::edit::test
