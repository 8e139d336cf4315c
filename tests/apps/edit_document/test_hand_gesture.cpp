// Objects moved by hand, without a tool: what they slide on, climb onto, hang back from, how they
// are turned, and that the ghost tells where they come to rest.
#include "apps/edit/tools/picking.h"
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

constexpr double kSlack = 2e-3;

/// A fixed table, 1.2 x 0.8 m, 2 cm thick, seen from the front and above.
class HandGestures : public testing::Test {
 protected:
  HandGestures() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write("table", {{{-0.6, -0.4, 0}, {0.6, 0.4, 0.02}}});
    write("box", {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.1}}});
    write("cup", {{{-0.03, -0.03, 0}, {0.03, 0.03, 0.06}}});
    write("book", {{{-0.02, -0.08, 0}, {0.02, 0.08, 0.2}}});
    write("tray", {{{-0.15, -0.1, 0}, {0.15, 0.1, 0.01}},
                   {{-0.15, -0.1, 0.01}, {-0.145, 0.1, 0.03}},
                   {{0.145, -0.1, 0.01}, {0.15, 0.1, 0.03}}});
    document.import(folder.file("table.obj"), "table", true);
    top = world_box(document.object("table")).upper.z();
    hand.view = View();
    hand.view.width_px = 1280, hand.view.height_px = 720;
    hand.view.eye = Vec3(0, -1.6, 1.2), hand.view.target = Vec3(0, 0, 0.05);
  }

  void write(const std::string& name, const std::vector<Aabb>& boxes) {
    write_boxes(folder.file(name + ".obj"), boxes);
  }

  void put(const std::string& model, const std::string& name, double x, double y, double z = 0.01) {
    document.import(folder.file(model + ".obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = Vec3(x, y, top + z);
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
    document->select({});
    steps = document->history().num_done;
  }

  Vec3 at(const std::string& name) { return document.object(name).pose.translation; }
  Aabb box(const std::string& name) { return world_box(document.object(name)); }

  /// Presses on the middle of an object, and moves so that its foot points there.
  void pull(const std::string& name, const Vec3& to, int num_moves = 8) {
    const Aabb here = box(name);
    from = hand.px(here.centre());
    const Vec2 foot = hand.px(Vec3(here.centre().x(), here.centre().y(), here.lower.z()));
    end = from + hand.px(to) - foot;
    hand.press(from);
    for (int i = 1; i <= num_moves; ++i) move(from + (end - from) * i / num_moves);
  }
  void move(const Vec2& px) {
    hand.move(px);
    document->wait_until_idle();
  }
  /// Lets go. @return whether the object came to rest where the ghost was.
  void let_go() {
    const std::optional<Ghost> ghost = document->ghost();
    hand.release(end);
    document->wait_until_idle();
    EXPECT_EQ(wrong_with(*document->snapshot()), "");
    EXPECT_FALSE(document->ghost());
    if (!ghost || !ghost->ok) return;
    for (const Ghost::Member& member : ghost->members)
      EXPECT_LT((document->snapshot()->find(member.id)->object->pose.translation -
                 member.pose.translation)
                    .norm(),
                1e-6)
          << (*document->snapshot()->find(member.id))->name;
  }
  void drag(const std::string& name, const Vec3& to) {
    pull(name, to);
    let_go();
  }
  size_t new_steps() const { return document->history().num_done - steps; }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  double top = 0;
  size_t steps = 0;
  Vec2 from, end;
};

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

// --- in place: lifted, turned, settled ---------------------------------------------------------

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

}  // namespace
}  // namespace trivet::edit::test
