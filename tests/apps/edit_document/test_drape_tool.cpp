// DRAPE with the mouse: a sheet that is seen as it comes down, a cable from place to place.
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"
#include "core/flex/flexible.h"

namespace trivet::edit::test {
namespace {

class Draping : public testing::Test {
 protected:
  Draping() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("table.obj"), {{{-0.3, -0.2, 0}, {0.3, 0.2, 0.3}}});
    write_boxes(folder.file("socket.obj"), {{{0.6, -0.05, 0}, {0.7, 0.05, 0.1}}});
    document.import(folder.file("table.obj"), "table", true);
    document.import(folder.file("socket.obj"), "socket", true);
    hand.look_down({Vec3(-0.8, -0.5, 0), Vec3(0.8, 0.5, 0.1)});
    toolbox.take(ToolKind::Drape);
    toolbox.options().drape_width = 0.8;
    toolbox.options().drape_length = 0.6;
    QObject::connect(&*document, &Document::snapshot_changed, [this] {
      const auto& falling = document->snapshot()->falling;
      if (falling) heights.push_back(world_box_of(*falling));
    });
  }
  static double world_box_of(const Object& object) {
    double lowest = kInfinity;
    for (const Vec3& p : object.model->mesh.vertices) lowest = std::min(lowest, p.z());
    return lowest;
  }
  bool has(const char* name) const { return document->snapshot()->find(name) != nullptr; }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
  std::vector<double> heights;  // of what was seen coming down
};

TEST_F(Draping, AClickLetsASheetComeDownLive) {
  hand.move(hand.px(Vec3(0.01, 0, 0.3)));
  EXPECT_EQ(toolbox.overlay(hand.view).lines.size(), 4u);
  hand.click(hand.px(Vec3(0.01, 0, 0.3)));
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_TRUE(has("cotton")) << document.last_text();
  EXPECT_FALSE(document->snapshot()->falling);
  ASSERT_GE(heights.size(), 3u) << "it is seen as it comes down";
  EXPECT_GT(heights.front(), 0.3);
  EXPECT_LT(heights.back(), 0.25);
  EXPECT_TRUE(document.object("cotton").flexible);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_FALSE(has("cotton"));
  ASSERT_TRUE(document.done(document->redo()));
  EXPECT_TRUE(has("cotton"));
}

TEST_F(Draping, EscapeTakesItBack) {
  toolbox.options().drape_cell = 0.008;  // it takes long
  const size_t steps = document->history().num_done;
  hand.move(hand.px(Vec3(0, 0, 0.3)));
  QObject::connect(&*document, &Document::snapshot_changed, [this] {
    if (document->snapshot()->falling) hand.key(KeyEvent::Key::Escape);
  });
  hand.click(hand.px(Vec3(0, 0, 0.3)));
  ASSERT_TRUE(document->wait_until_idle());
  EXPECT_FALSE(has("cotton"));
  EXPECT_FALSE(document->snapshot()->falling);
  EXPECT_EQ(document->history().num_done, steps);
  EXPECT_NE(document.last_text().find("cancelled"), std::string::npos) << document.last_text();
}

TEST_F(Draping, ClicksLayACableThatItsEndsHold) {
  toolbox.options().drape_material = "lead";
  hand.click(hand.px(Vec3(0.2, 0, 0.3)));
  EXPECT_TRUE(toolbox.tool().is_active());
  hand.click(hand.px(Vec3(0.45, 0.2, 0)));
  hand.move(hand.px(Vec3(0.65, 0, 0.1)));
  EXPECT_GE(toolbox.overlay(hand.view).lines.size(), 2u);
  hand.click(hand.px(Vec3(0.65, 0, 0.1)));
  hand.click(hand.px(Vec3(0.1, 0.4, 0)));
  EXPECT_TRUE(hand.key(KeyEvent::Key::Backspace));
  EXPECT_TRUE(hand.key(KeyEvent::Key::Return));
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_TRUE(has("lead")) << document.last_text();
  const Flexible& lead = *document.object("lead").flexible;
  ASSERT_EQ(lead.ties.size(), 2u);
  EXPECT_EQ(lead.ties[0].name, "table");
  EXPECT_EQ(lead.ties[1].name, "socket");
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  hand.click(hand.px(Vec3(0, 0, 0.3)));
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  EXPECT_FALSE(toolbox.tool().is_active());
}

}  // namespace
}  // namespace trivet::edit::test
