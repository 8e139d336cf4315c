// The z-list view shows the motion under the hand, with the answer of the same query by itself, and
// only as often as it may.
#include <Eigen/Geometry>
#include <QCoreApplication>
#include <chrono>
#include <cmath>
#include <thread>

#include "apps/edit/document/drag_motion.h"
#include "apps/edit_document/hand.h"

namespace trivet::edit::test {
namespace {

class ZListViews : public testing::Test {
 protected:
  ZListViews() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {}
  void SetUp() override {
    ASSERT_TRUE(document.done(document->open_demo("breakfast"))) << document.last_text();
    hand.look_at(document->snapshot()->box());
    document->watch_zlists(true);
  }
  /// The same query by BVHs alone.
  FirstContact answer(const ZListView& view, const std::vector<ObjectId>& moving) const {
    std::vector<Body> a, b;
    for (const ObjectSnapshot& object : document->snapshot()->objects) {
      if (!object->placed) continue;
      const bool moves = std::find(moving.begin(), moving.end(), object.id) != moving.end();
      (moves ? a : b).push_back(body_of(*object.object));
    }
    FirstContactQuery query{a, b, true, view.motion, {}};
    query.clearance.distance = view.clearance;
    return first_contact(query);
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(ZListViews, ShowWhatStopsADrag) {
  toolbox.take(ToolKind::Push);
  const auto at = hand.seen("glass_back");
  ASSERT_TRUE(at);
  const auto is_stopped = [&] {
    const auto& drag = document->snapshot()->drag;
    return drag && drag->blocked && !drag->blocked_by.name.empty();
  };
  for (const Vec2& way : {Vec2(16, 0), Vec2(-16, 0), Vec2(0, 10), Vec2(0, -10)}) {
    hand.move(*at);
    hand.press(*at);
    for (int i = 1; i <= 20 && !is_stopped(); ++i) {
      hand.move(*at + i * way);
      ASSERT_TRUE(document->wait_until_idle());
    }
    if (is_stopped()) break;
    hand.key(KeyEvent::Key::Escape);
    hand.release(*at);
  }
  ASSERT_TRUE(is_stopped());
  ASSERT_TRUE(document->zlists());
  const ZListView& view = *document->zlists();
  EXPECT_EQ(view.committed, document->snapshot()->committed);
  EXPECT_EQ(view.motion.kind, Motion::Kind::Translation);
  EXPECT_EQ(view.motion.axis.z(), 0);
  const FirstContact truth = answer(view, document->snapshot()->drag->moving);
  ASSERT_NE(truth.status, FirstContact::Status::Free);
  EXPECT_EQ(view.lists.contact.time, truth.time);
  EXPECT_EQ(view.lists.contact.face_fixed, truth.face_fixed);
  EXPECT_LE(view.lists.lower(), truth.time);
  EXPECT_GE(view.lists.upper(), truth.time);
  EXPECT_LT(truth.time, 0.01);
  EXPECT_GT(view.lists.depths.num_doubtful, 0);
  ASSERT_FALSE(view.confirmed.empty());
  EXPECT_FALSE(view.fixed_faces.empty());
  const bool listed =
      std::any_of(view.confirmed.begin(), view.confirmed.end(), [&](const ConfirmedPair& pair) {
        return pair.fixed.object == view.touched && pair.fixed.face == truth.face_fixed;
      });
  EXPECT_TRUE(listed || view.lists.num_confirmed > ZListView::kMostListed);
  hand.release(*at);
  ASSERT_TRUE(document->wait_until_idle());
}

TEST_F(ZListViews, ShowTheFallOfAPut) {
  document->select_only(document.id("cup_front"));
  toolbox.take(ToolKind::Put);
  const ObjectSnapshot* const plate = document->snapshot()->find("plate_front");
  hand.move(hand.px((*plate)->centre_of_mass()));
  ASSERT_TRUE(document->wait_until_idle());
  ASSERT_TRUE(document->ghost());
  ASSERT_TRUE(document->zlists());
  const ZListView& view = *document->zlists();
  EXPECT_EQ(view.motion.axis, Vec3(0, 0, -1));
  EXPECT_EQ(view.lists.contact.status, FirstContact::Status::Contact);
  EXPECT_GT(view.lists.contact.time, 1e-3);
  EXPECT_FALSE(view.touched.empty());
  EXPECT_NE(view.touched, "cup_front");
  EXPECT_FALSE(view.lists.depths.frame.empty());
}

TEST_F(ZListViews, AreNotComputedWhenNobodyLooks) {
  document->watch_zlists(false);
  int num_changes = 0;
  QObject::connect(&*document, &Document::zlists_changed, [&] { ++num_changes; });
  toolbox.take(ToolKind::Push);
  const auto at = hand.seen("teapot");
  ASSERT_TRUE(at);
  hand.drag(*at, *at + Vec2(20, -10), 5);
  EXPECT_EQ(num_changes, 0);
  EXPECT_FALSE(document->zlists());
}

// Views come while the mouse moves. Between two of them there is a rest: a quick hand is not
// followed everywhere, but to its end.
TEST_F(ZListViews, LeaveOutWhatAQuickHandPasses) {
  using Clock = std::chrono::steady_clock;
  constexpr int kFewestMoves = 120, kMostMoves = 30'000;  // of 2 ms each, or a little more
  constexpr std::chrono::milliseconds kRest(50);
  std::vector<Vec3> seen;  // where the object was
  double computing_ms = 0;
  QObject::connect(&*document, &Document::zlists_changed, [&] {
    seen.push_back(document.object("teapot").pose.translation);
    computing_ms += document->zlists()->milliseconds;
  });
  toolbox.take(ToolKind::Move);
  const auto at = hand.seen("teapot");
  ASSERT_TRUE(at);
  const Clock::time_point begin = Clock::now();
  hand.move(*at);
  hand.press(*at);
  int num_moves = 0;
  while (num_moves < kFewestMoves || (seen.size() < 3 && num_moves < kMostMoves)) {
    ++num_moves;
    hand.move(*at + (num_moves % kFewestMoves) * Vec2(0.2, -0.5));
    QCoreApplication::processEvents(QEventLoop::AllEvents, 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const size_t num_while_moving = seen.size();
  EXPECT_GE(num_while_moving, 3u);
  EXPECT_NE(seen.front(), seen[num_while_moving - 1]);
  ASSERT_TRUE(document->wait_until_idle());
  const auto took = Clock::now() - begin;
  const auto num_views = static_cast<int>(seen.size());
  EXPECT_LE((num_views - 1) * kRest, took);
  EXPECT_LT(num_views, num_moves);
  // The last view is of where the object is now.
  const auto snapshot = document->snapshot();
  ASSERT_TRUE(snapshot->drag);
  const ZListView& view = *document->zlists();
  const FirstContact truth = answer(view, snapshot->drag->moving);
  EXPECT_EQ(view.lists.contact.status, truth.status);
  EXPECT_EQ(view.lists.contact.time, truth.time);
  std::printf("%d moves in %.0f ms: %d views, %zu of them while the mouse moved, %.1f ms each\n",
              num_moves, std::chrono::duration<double, std::milli>(took).count(), num_views,
              num_while_moving, computing_ms / num_views);
  hand.release(*at);
}

TEST(DragMotion, LeadsOnStraight) {
  PushOperation push;
  DragMotion motion(push, {{}, Vec3(1, 2, 3)}, 0.5);
  DragGoal goal;
  goal.to = Vec3(1, 2, 0);
  EXPECT_FALSE(motion.next({{}, Vec3(1, 2, 3)}, goal));  // there is no way left
  goal.to = Vec3(3, 2, 0);
  const auto ahead = motion.next({{}, Vec3(1.5, 2, 3.1)}, goal);
  ASSERT_TRUE(ahead);
  EXPECT_EQ(ahead->axis, Vec3::UnitX());
  EXPECT_EQ(ahead->limit, 1.5);
  goal.to = Vec3(1.5, 3, 0);
  const auto arrived = motion.next({{}, Vec3(1.5, 3, 3.1)}, goal);  // as it last went
  ASSERT_TRUE(arrived);
  EXPECT_EQ(arrived->axis, Vec3::UnitY());
  EXPECT_EQ(arrived->limit, 0.5);
  const auto rests = motion.next({{}, Vec3(1.5, 3, 3.1)}, goal);
  ASSERT_TRUE(rests);
  EXPECT_EQ(rests->axis, Vec3::UnitY());
}

TEST(DragMotion, LeadsOnAboutTheAxisOfATurn) {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized(), centre(0.3, -0.1, 0.7);
  const Pose start{Rotation{0.7, 0.1, -0.4, 0.2}.normalized(), Vec3(1, 2, 3)};
  DragMotion motion(RotateOperation{}, start, 0.5);
  EXPECT_FALSE(motion.next(start, {}));
  double before = 0;
  for (const double angle : {0.01, 0.4, 0.2}) {  // the last goes back
    const Pose now = moved_pose(start, Motion::rotation(centre, axis, 1), std::tan(angle / 2));
    const auto on = motion.next(now, {});
    ASSERT_TRUE(on);
    EXPECT_EQ(on->kind, Motion::Kind::Rotation);
    EXPECT_LT((on->axis - (angle > before ? 1 : -1) * axis).norm(), 1e-9);
    EXPECT_LT((on->centre - centre).cross(axis).norm(), 1e-9);
    const auto again = motion.next(now, {});  // it is stopped
    ASSERT_TRUE(again);
    EXPECT_EQ(again->axis, on->axis);
    before = angle;
  }
}

}  // namespace
}  // namespace trivet::edit::test
