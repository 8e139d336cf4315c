// PUT where the mouse points: in a shelf, under its boards, at its walls; what is in hand.
#include "apps/edit/tools/picking.h"
#include "apps/edit/tools/placing.h"
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"
#include "core/index/ray.h"
#include "support/random_shapes.h"

namespace trivet::edit::test {
namespace {

constexpr double kNear = 1e-3;

/// A shelf of three boards with a back, and things that are not placed yet.
class PutTool : public testing::Test {
 protected:
  PutTool() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    const std::string shelf = folder.file("shelf.obj"), book = folder.file("book.obj");
    write_boxes(shelf, shelf_boxes());
    write_boxes(book, {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.2}}});
    write_boxes(folder.file("coaster.obj"), {{{-0.05, -0.05, 0}, {0.05, 0.05, 0.02}}});
    document.import(shelf, "shelf", true);
    for (const char* const name : {"book", "other"}) document.import(book, name);
    document.import(folder.file("coaster.obj"), "coaster");
    look_from(Vec3(0, -2, 1.2));
    toolbox.take(ToolKind::Put);
  }

  void look_from(const Vec3& eye) {
    hand.view = View();
    hand.view.width_px = 1280, hand.view.height_px = 720;
    hand.view.eye = eye, hand.view.target = Vec3(0, 0, 0.5);
  }

  const Ghost& ghost_at(const Vec3& point) {
    hand.move(hand.px(point));
    document->wait_until_idle();
    if (!document->ghost()) throw std::runtime_error("there is no ghost");
    return *document->ghost();
  }

  void take(const std::string& name) { document->select_only(document.id(name)); }

  Aabb put(const std::string& name, const Vec3& at) {
    take(name);
    hand.click(hand.px(at));
    EXPECT_EQ(document.object(name).state, ObjectState::Stable) << document.last_text();
    return world_box(document.object(name));
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(PutTool, PutsUnderABoardWhereItIsPointedAt) {
  const Aabb box = put("book", Vec3(0, -0.1, 0.42));
  EXPECT_NEAR(box.lower.z(), 0.42, kNear);
  EXPECT_NEAR(box.centre().x(), 0, 0.005);
  EXPECT_NEAR(box.centre().y(), -0.1, 0.005);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(PutTool, PutsOnTopUnderTheOpenSky) {
  EXPECT_NEAR(put("book", Vec3(0.2, 0, 0.82)).lower.z(), 0.82, kNear);
  EXPECT_NEAR(put("other", Vec3(0, -0.6, 0)).lower.z(), 0, kNear);
  // The side of the upper board, in the open: from above everything. Its edge is too narrow to say
  // whether the coaster stays there.
  take("coaster");
  const Ghost& ghost = ghost_at(Vec3(0, -0.2, 0.81));
  EXPECT_GT(std::get<PutOperation>(ghost.operation).start.translation.z(), 0.8);
}

TEST_F(PutTool, PutsBesideTheWallThatIsPointedAt) {
  const Aabb box = put("book", Vec3(0.1, 0.2, 0.5));
  EXPECT_NEAR(box.lower.z(), 0.42, kNear);
  EXPECT_NEAR(box.centre().x(), 0.1, 0.005);
  EXPECT_LT(box.upper.y(), 0.2);
  EXPECT_GT(box.upper.y(), 0.19);
}

TEST_F(PutTool, DropsBelowTheUndersideThatIsPointedAt) {
  look_from(Vec3(0, -2, 0.3));
  EXPECT_NEAR(put("book", Vec3(0.1, -0.15, 0.8)).lower.z(), 0.42, kNear);
}

TEST_F(PutTool, StartsAboveLowThingsUnderTheBoard) {
  put("coaster", Vec3(0, -0.1, 0.42));
  take("book");
  const Ghost& ghost = ghost_at(Vec3(0.06, -0.1, 0.42));
  EXPECT_NEAR(std::get<PutOperation>(ghost.operation).start.translation.z(), 0.46, kNear);
  EXPECT_TRUE(ghost.ok) << ghost.text;
}

TEST_F(PutTool, ShowsARefusedGhostAtItsStartWithTheReason) {
  put("book", Vec3(0, -0.1, 0.42));
  take("other");
  const Ghost& ghost = ghost_at(Vec3(0.07, -0.1, 0.42));
  EXPECT_FALSE(ghost.ok);
  EXPECT_NE(ghost.text.find("book"), std::string::npos) << ghost.text;
  ASSERT_EQ(ghost.members.size(), 1u);
  EXPECT_EQ(ghost.members[0].id, document.id("other"));
  EXPECT_EQ(ghost.members[0].pose.translation,
            std::get<PutOperation>(ghost.operation).start.translation);
}

TEST_F(PutTool, HasNothingInHandAfterAPut) {
  take("book");
  EXPECT_EQ(toolbox.in_hand(), "book");
  hand.click(hand.px(Vec3(0, -0.1, 0.42)));
  EXPECT_EQ(toolbox.in_hand(), "");
  const size_t steps = document->history().num_done;
  hand.click(hand.px(Vec3(0.3, -0.1, 0.42)));
  EXPECT_FALSE(document->ghost());
  EXPECT_EQ(document->history().num_done, steps) << "the click moved what lay there";
  // The first click on it takes it, the second puts it.
  hand.click(*hand.seen("book"));
  EXPECT_EQ(toolbox.in_hand(), "book");
  EXPECT_EQ(document->history().num_done, steps);
  hand.click(hand.px(Vec3(0.3, -0.1, 0.42)));
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_NEAR(document.object("book").pose.translation.x(), 0.3, 0.01);
}

TEST_F(PutTool, KeepsInHandWhatWasRefused) {
  put("book", Vec3(0, -0.1, 0.42));
  take("other");
  hand.click(hand.px(Vec3(0.07, -0.1, 0.42)));
  EXPECT_EQ(document->snapshot()->find("other")->object->placed, false);
  EXPECT_EQ(toolbox.in_hand(), "other");
}

TEST_F(PutTool, DropsByEscapeAndTakesTheNextWhenAsked) {
  take("book");
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  EXPECT_EQ(toolbox.in_hand(), "");
  EXPECT_EQ(document->selection().active(), document.id("book"));
  EXPECT_TRUE(hand.key('n'));
  EXPECT_EQ(toolbox.in_hand(), "other");
  EXPECT_TRUE(hand.key('n'));
  EXPECT_EQ(toolbox.in_hand(), "coaster");
  toolbox.options().take_next = true;
  hand.click(hand.px(Vec3(0.3, -0.1, 0.42)));
  EXPECT_EQ(toolbox.in_hand(), "book");
}

TEST_F(PutTool, LeavesFixedAndLockedThings) {
  take("book");
  hand.key(KeyEvent::Key::Escape);
  const size_t steps = document->history().num_done;
  hand.click(*hand.seen("shelf"));
  hand.click(*hand.seen("shelf"));
  EXPECT_EQ(toolbox.in_hand(), "");
  EXPECT_EQ(document->history().num_done, steps);
  EXPECT_NE(toolbox.hint().find("fixed"), std::string::npos);
}

// By all faces: nothing is above the start under the open sky; else it is below the overhang.
TEST_F(PutTool, StartsBelowWhatIsAboveThePoint) {
  put("coaster", Vec3(0, -0.1, 0.42));
  const SceneSnapshot& scene = *document->snapshot();
  const std::vector<ObjectId> moving{document.id("book")};
  const Object& book = document.object("book");
  trivet::test::Random random(7);
  int num_below = 0, num_open = 0;
  for (int i = 0; i < 300; ++i) {
    const auto at = pick(scene, hand.view.ray({random.uniform(300, 980), random.uniform(50, 700)}));
    if (!at || at->normal.z() < 0.9) continue;
    Object there = book;
    there.pose = put_start(scene, book, moving, *at, 0.02, false);
    const Aabb box = world_box(there);
    double ceiling = kInfinity;
    for (const ObjectSnapshot& o : scene.objects)
      if (o->placed)
        if (const auto hit = first_hit_brute_force(*o->shape, o->world_from_object(),
                                                   {at->point + Vec3(0, 0, 1e-4), Vec3::UnitZ()}))
          ceiling = std::min(ceiling, at->point.z() + 1e-4 + hit->time);
    EXPECT_GT(box.lower.z(), at->point.z());
    ++(ceiling < kInfinity ? num_below : num_open);
    if (ceiling < kInfinity) {
      EXPECT_LT(box.upper.z(), ceiling);
      EXPECT_LT(box.lower.z(), at->point.z() + 0.05);
    } else if (box.upper.x() > -0.52 && box.lower.x() < 0.52 && box.upper.y() > -0.2 &&
               box.lower.y() < 0.22) {
      EXPECT_NEAR(box.lower.z(), 0.84, kNear);
    } else {
      EXPECT_NEAR(box.lower.z(), at->point.z() + 0.02, kNear);
    }
  }
  EXPECT_GT(num_below, 20);
  EXPECT_GT(num_open, 20);
}

}  // namespace
}  // namespace trivet::edit::test
