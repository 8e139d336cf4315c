// PAINT: places along strokes; strokes with the mouse.
#include <chrono>
#include <random>
#include <thread>

#include "apps/edit/document/paint.h"
#include "apps/edit_document/hand.h"
#include "apps/edit_document/scene_checks.h"

namespace trivet::edit::test {
namespace {

/// By walking in tiny steps.
std::vector<Vec3> spaced_slowly(const std::vector<Vec3>& stroke, double spacing) {
  std::vector<Vec3> out{stroke.front()};
  double walked = 0;
  constexpr int kParts = 20000;
  for (size_t i = 0; i + 1 < stroke.size(); ++i)
    for (int k = 1; k <= kParts; ++k) {
      walked += (stroke[i + 1] - stroke[i]).norm() / kParts;
      if (walked < spacing * double(out.size())) continue;
      out.push_back(stroke[i] + (stroke[i + 1] - stroke[i]) * k / kParts);
    }
  return out;
}

TEST(Paint, SpacesPlacesAlongTheStroke) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int num_places = 0;
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3> stroke;
    for (int k = 0; k < 1 + i % 6; ++k)
      stroke.emplace_back(uniform(random), uniform(random), 0.1 * uniform(random));
    if (i % 3 == 0) stroke.push_back(stroke.back());  // the mouse stands still
    const double spacing = 0.05 + std::abs(uniform(random));
    const std::vector<Vec3> found = spaced(stroke, spacing);
    const std::vector<Vec3> expected = spaced_slowly(stroke, spacing);
    ASSERT_EQ(found.size(), expected.size()) << i;
    for (size_t k = 0; k < found.size(); ++k) EXPECT_LT((found[k] - expected[k]).norm(), 1e-3);
    num_places += static_cast<int>(found.size());
  }
  EXPECT_GT(num_places, 60);
  EXPECT_TRUE(spaced({}, 1).empty());
  EXPECT_TRUE(spaced(std::vector<Vec3>{Vec3::Zero()}, 0).empty());
  const std::vector<Vec3> far{Vec3::Zero(), Vec3(1e9, 0, 0)};
  EXPECT_EQ(spaced(far, 1e-3).size(), 1000u) << "no stroke makes more";
}

class Painting : public testing::Test {
 protected:
  Painting() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("table.obj"), {{{-0.6, -0.4, 0}, {0.6, 0.4, 0.02}}});
    write_boxes(folder.file("cup.obj"), {{{-0.03, -0.02, 0}, {0.03, 0.02, 0.08}}});
    document.import(folder.file("table.obj"), "table", true);
    document.import(folder.file("cup.obj"), "cup");
    hand.look_down({Vec3(-0.6, -0.4, 0), Vec3(0.6, 0.4, 0.1)});
    toolbox.take(ToolKind::Paint);
    document->select_only(document.id("cup"));
  }

  void stroke(const Vec3& from, const Vec3& to) { hand.drag(hand.px(from), hand.px(to)); }

  std::vector<Pose> poses() const {
    std::vector<Pose> out;
    for (const ObjectSnapshot& o : document->snapshot()->objects)
      if (o->placed && !o->fixed) out.push_back(o->pose);
    return out;
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Painting, SetsDownCopiesAsOneStep) {
  const size_t steps = document->history().num_done;
  stroke(Vec3(-0.4, 0.1, 0), Vec3(0.4, 0.1, 0));
  EXPECT_EQ(document->history().num_done, steps + 1);
  const std::vector<Pose> all = poses();
  EXPECT_EQ(all.size(), 11u) << document.last_text();  // 0.8 m by 75.7 mm
  for (const Pose& pose : all) EXPECT_NEAR(pose.translation.y(), 0.1, 0.005);
  EXPECT_FALSE(document.object("cup").placed) << "copies are painted";
  EXPECT_EQ(document->selection().active(), document.id("cup")) << "the next stroke paints it, too";
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_TRUE(poses().empty());
}

TEST_F(Painting, FollowsSpacingSeedAndTurns) {
  toolbox.options().paint_spacing = 0.2;
  toolbox.options().paint_turned = false;
  stroke(Vec3(-0.4, -0.2, 0), Vec3(0.41, -0.2, 0));
  const std::vector<Pose> straight = poses();
  ASSERT_EQ(straight.size(), 5u);
  for (size_t i = 0; i + 1 < straight.size(); ++i)
    EXPECT_NEAR(straight[i + 1].translation.x() - straight[i].translation.x(), 0.2, 0.006);
  for (const Pose& pose : straight) EXPECT_NEAR(std::abs(pose.rotation.w), 1, 1e-6);
  document.done(document->undo());
  toolbox.options().paint_turned = true;
  const auto painted_again = [&](std::uint64_t seed) {
    toolbox.take(ToolKind::Paint);
    toolbox.options().paint_seed = seed;
    stroke(Vec3(-0.4, -0.2, 0), Vec3(0.41, -0.2, 0));
    std::vector<double> turns;
    for (const Pose& pose : poses()) turns.push_back(pose.rotation.w);
    document.done(document->undo());
    return turns;
  };
  const std::vector<double> first = painted_again(3);
  EXPECT_EQ(first.size(), 5u);
  EXPECT_EQ(painted_again(3), first);
  EXPECT_NE(painted_again(4), first);
}

TEST_F(Painting, LeavesOutWhatDoesNotFit) {
  toolbox.options().paint_spacing = 0.02;  // narrower than the cups
  toolbox.options().paint_turned = false;
  stroke(Vec3(-0.2, 0, 0), Vec3(0.2, 0, 0));
  EXPECT_GE(poses().size(), 3u);
  EXPECT_LT(poses().size(), 20u);
  EXPECT_NE(document.last_text().find("refused"), std::string::npos) << document.last_text();
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST(Paint, SpraysOverADisc) {
  const std::vector<Vec3> places = sprayed(Vec3(1, 2, 3), 0.5, 200, 7);
  ASSERT_EQ(places.size(), 200u);
  double widest = 0;
  for (const Vec3& place : places) {
    EXPECT_EQ(place.z(), 3);
    widest = std::max(widest, (place - Vec3(1, 2, 3)).norm());
  }
  EXPECT_LE(widest, 0.5);
  EXPECT_GT(widest, 0.4);
  EXPECT_EQ(sprayed(Vec3(1, 2, 3), 0.5, 200, 7), places);
}

TEST_F(Painting, PoursAPileWhileTheButtonIsDown) {
  toolbox.options().paint_pile = true;
  toolbox.options().paint_flow = 100;
  const size_t steps = document->history().num_done;
  hand.press(hand.px(Vec3(0.1, 0, 0)));
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
  hand.release(hand.px(Vec3(0.1, 0, 0)));
  document->wait_until_idle();
  EXPECT_EQ(document->history().num_done, steps + 1) << document.last_text();
  const std::vector<Pose> all = poses();
  EXPECT_GE(all.size(), 8u) << document.last_text();
  double highest = 0;
  for (const Pose& pose : all) highest = std::max(highest, pose.translation.z());
  EXPECT_GT(highest, 0.05) << "none lies on another one";
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
}

TEST_F(Painting, ShowsPlacesAndCancels) {
  hand.press(hand.px(Vec3(-0.3, 0, 0)));
  hand.move(hand.px(Vec3(0.3, 0, 0)));
  EXPECT_EQ(toolbox.overlay(hand.view).note, "8 copies");
  EXPECT_TRUE(hand.key(KeyEvent::Key::Escape));
  hand.release(hand.px(Vec3(0.3, 0, 0)));
  document->wait_until_idle();
  EXPECT_TRUE(poses().empty());
  document->select({});
  stroke(Vec3(-0.3, 0, 0), Vec3(0.3, 0, 0));
  EXPECT_TRUE(poses().empty());
  EXPECT_NE(toolbox.hint().find("Select"), std::string::npos);
}

}  // namespace
}  // namespace trivet::edit::test
