// Selected objects move together with their loads, as one step.
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

class Together : public testing::Test {
 protected:
  Together() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    document.done(document->open_demo("breakfast"));
    hand.look_at(document->snapshot()->box());
    Selection both;
    both.objects = {document.id("saucer_front"), document.id("bowl")};
    document->select(both);
  }

  Vec3 at(const std::string& name) const { return document.object(name).pose.translation; }

  /// Expects that both objects, the load of the saucer, and no others have moved.
  void expect_moved(const SceneSnapshot& before, size_t steps) {
    EXPECT_EQ(document->history().num_done, steps + 1) << document.last_text();
    EXPECT_EQ(wrong_with(*document->snapshot()), "");
    for (const ObjectSnapshot& o : before.objects) {
      const bool moves = o->name == "saucer_front" || o->name == "cup_front" ||
                         o->name == "spoon_front" || o->name == "bowl" || is_on("bowl", o->name);
      EXPECT_EQ((at(o->name) - o->pose.translation).norm() > 1e-3, moves) << o->name;
    }
    EXPECT_EQ(document->selection().objects.size(), 2u);
  }
  bool is_on(const std::string& support, const std::string& name) const {
    for (const LoadSupport::Entry& e : document->snapshot()->support->entries)
      if (e.object == document.id(support))
        for (const ObjectId load : e.loads)
          if (document.id(name) == load) return true;
    return false;
  }
  void undo(std::uint64_t first) {
    ASSERT_TRUE(document.done(document->undo()));
    EXPECT_EQ(fingerprint(*document->snapshot()), first);
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Together, DragMovesWholeSelection) {
  const auto before = document->snapshot();
  const std::uint64_t first = fingerprint(*before);
  for (const ToolKind kind : {ToolKind::Push, ToolKind::Move, ToolKind::PickUp}) {
    SCOPED_TRACE(static_cast<int>(kind));
    toolbox.take(kind);
    const size_t steps = document->history().num_done;
    const auto grabbed = hand.seen("saucer_front");
    ASSERT_TRUE(grabbed);
    const Vec2 way = kind == ToolKind::Push ? Vec2(10, -6) : Vec2(0, -40);
    hand.drag(*grabbed, *grabbed + way, 8);
    EXPECT_EQ(document->selection().active(), document.id("saucer_front"));
    expect_moved(*before, steps);
    const Vec3 moved = at("saucer_front") - (*before->find("saucer_front"))->pose.translation;
    EXPECT_LT((at("bowl") - (*before->find("bowl"))->pose.translation - moved).norm(), 0.02);
    undo(first);
  }
}

TEST_F(Together, RotationTurnsSelectionAboutOneAxis) {
  const auto before = document->snapshot();
  toolbox.take(ToolKind::PickUp);
  ASSERT_TRUE(toolbox.pick_up());  // by key
  ASSERT_TRUE(document->wait_until_idle());
  expect_moved(*before, 0);
  const double apart = (at("bowl") - at("saucer_front")).norm();
  toolbox.take(ToolKind::Rotate);
  const auto grabbed = hand.seen("bowl");
  ASSERT_TRUE(grabbed);
  hand.drag(*grabbed, *grabbed + Vec2(25, 5), 6);
  EXPECT_EQ(document->history().num_done, 2u) << document.last_text();
  EXPECT_NEAR((at("bowl") - at("saucer_front")).norm(), apart, 1e-9);
}

TEST_F(Together, GrabOfUnselectedObjectMovesItAlone) {
  toolbox.take(ToolKind::Push);
  const auto before = document->snapshot();
  const auto grabbed = hand.seen("teapot");
  ASSERT_TRUE(grabbed);
  hand.drag(*grabbed, *grabbed + Vec2(8, -4), 6);
  EXPECT_EQ(document->selection().objects, std::vector{document.id("teapot")});
  EXPECT_EQ(at("bowl"), (*before->find("bowl"))->pose.translation);
}

TEST_F(Together, FixedObjectRefusesMove) {
  Selection with_table;
  with_table.objects = {document.id("table"), document.id("bowl")};
  document->select(with_table);
  toolbox.take(ToolKind::Push);
  const auto grabbed = hand.seen("bowl");
  ASSERT_TRUE(grabbed);
  hand.drag(*grabbed, *grabbed + Vec2(20, -4), 4);
  EXPECT_EQ(document->history().num_done, 0u);
  EXPECT_NE(document.last_text().find("\"table\" is fixed"), std::string::npos)
      << document.last_text();
}

}  // namespace
}  // namespace trivet::edit::test
