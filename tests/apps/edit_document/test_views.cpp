// Sections of views, projection volumes of motions, PUSH along walls.
#include <Eigen/Geometry>

#include "apps/edit/document/drag_motion.h"
#include "apps/edit/tools/constraint_camera.h"
#include "apps/edit/tools/operation_of.h"
#include "apps/edit/tools/picking.h"
#include "apps/edit/tools/section.h"
#include "apps/edit_document/hand.h"
#include "ops/placement/neighbourhood.h"
#include "support/random_shapes.h"

namespace trivet::edit::test {
namespace {

/// A book on the lower board of a shelf, with a coaster on it.
class Views : public testing::Test {
 protected:
  Views() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("shelf.obj"), shelf_boxes());
    write_boxes(folder.file("book.obj"), {{{-0.1, -0.08, 0}, {0.1, 0.08, 0.05}}});
    document.import(folder.file("shelf.obj"), "shelf", true);
    put("book", Vec3(0, -0.05, 0.05));
    put("load", Vec3(-0.06, -0.05, 0.12));
    document->select_only(document.id("book"));
  }

  void put(const std::string& name, const Vec3& at) {
    document.import(folder.file("book.obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = at;
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
  }

  View from_contact() const {
    return constraint_view(*document->snapshot(), document->selection(), std::nullopt, 600, 400);
  }
  std::optional<double> depth(const View& view, const Section& section) const {
    return section_depth(*document->snapshot(), document->selection(), view, section, {});
  }
  std::string seen(const View& view, const Vec3& at) const {
    const auto hit = pick_near(*document->snapshot(), view, *view.project(at), {});
    return hit && hit->object ? (*document->snapshot()->find(*hit->object))->name : "";
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Views, CutAwayWhatHidesTheActiveObject) {
  View view = from_contact();
  const Vec3 centre = document.object("book").centre_of_mass();
  EXPECT_EQ(seen(view, centre), "shelf");
  EXPECT_FALSE(depth(view, {}));
  view.cut = depth(view, {true, true, 0});
  ASSERT_TRUE(view.cut);
  EXPECT_EQ(seen(view, centre), "load") << "what it carries is not cut";
  EXPECT_NEAR(view.depth(Vec3(0, 0, 0.12)), *view.cut, 0.01);
  // From the front nothing hides it; a plane that is moved cuts in any case.
  view.cut.reset();
  view.eye = view.target - Vec3(0, 3, 0);
  EXPECT_FALSE(depth(view, {true, true, 0}));
  EXPECT_TRUE(depth(view, {true, false, 0}));
  const double near_side = *depth(view, {true, false, 0});
  EXPECT_NEAR(*depth(view, {true, true, 0.1}), near_side + 0.1, 1e-12);
  view.cut = near_side + 0.1;
  EXPECT_EQ(seen(view, centre), "book") << "cut open: the inside of its other faces";
  // Without an active object, the middle of the scene.
  document->select({});
  EXPECT_NEAR(*depth(view, {true, false, 0}), view.depth(document->snapshot()->box().centre()),
              1e-9);
  EXPECT_FALSE(depth(view, {true, true, 0}));
}

// A drag sees past what is cut away, and goes where the mouse goes.
TEST_F(Views, DragUnderABoard) {
  hand.view = from_contact();
  hand.window = WindowKind::Constraint;
  hand.view.cut = depth(hand.view, {true, true, 0});
  toolbox.take(ToolKind::Push);
  const Vec3 before = document.object("book").pose.translation;
  const Vec2 from = hand.px(document.object("book").centre_of_mass() + Vec3(0.09, 0, 0));
  hand.drag(from, from + hand.px(Vec3(0.1, 0, 0)) - hand.px(Vec3::Zero()));
  const Vec3 after = document.object("book").pose.translation;
  EXPECT_NEAR((after - before).x(), 0.1, 0.01) << document.last_text();
}

TEST_F(Views, DragsShowTheirProjectionVolume) {
  toolbox.take(ToolKind::Push);
  hand.look_at(document->snapshot()->box());
  const auto from = hand.seen("book");
  ASSERT_TRUE(from);
  hand.press(*from);
  for (int i = 1; i <= 6; ++i) {
    hand.move(*from + Vec2(5 * i, 0));
    document->wait_until_idle();
  }
  const auto& drag = document->snapshot()->drag;
  ASSERT_TRUE(drag);
  EXPECT_EQ(drag->volume.size(), 12u);
  ASSERT_FALSE(drag->contacts.empty());
  EXPECT_GE(drag->contacts[0].hull.size(), 4u) << "of the whole contact";
  hand.release(*from + Vec2(30, 0));
  document->wait_until_idle();
}

TEST_F(Views, VolumesHoldTheMovingObjects) {
  trivet::test::Random random(4);
  const Object& book = document.object("book");
  for (int i = 0; i < 40; ++i) {
    const Pose pose{random.rotation(), random.in_cube(2)};
    const std::vector<Body> bodies{body_of(book, pose)};
    const Vec3 axis = random.direction();
    const bool turns = i % 2 > 0;
    const Vec3 centre = pose.translation + random.in_cube(1.5);
    const Motion motion = turns ? Motion::rotation(centre, axis, 1) : Motion::translation(axis, 1);
    const ProjectionVolume volume = projection_volume(bodies, motion);
    ASSERT_GE(volume.size(), 12u);
    // Extents about or along the motion: those of the lines hold those of the vertices, and are
    // hardly larger where it goes straight.
    Vec3 lower = Vec3::Constant(kInfinity), upper = -lower, low = lower, high = upper;
    const auto extents = [&](const Vec3& p) {
      const Vec3 v = p - centre;
      const Vec3 across = v - v.dot(axis) * axis;
      return turns ? Vec3(across.norm(), v.dot(axis), 0)
                   : Vec3(v.dot(axis), v.dot(axis.unitOrthogonal()),
                          v.dot(axis.cross(axis.unitOrthogonal())));
    };
    for (const auto& line : volume)
      for (const Vec3& p : line)
        lower = lower.cwiseMin(extents(p)), upper = upper.cwiseMax(extents(p));
    for (const Vec3& v : book.shape->mesh.vertices) {
      const Vec3 p = extents(bodies[0].world_from_object.apply(v));
      low = low.cwiseMin(p), high = high.cwiseMax(p);
    }
    EXPECT_TRUE(((low - lower).array() >= -1e-6).all()) << i;
    EXPECT_TRUE(((upper - high).array() >= -1e-6).all()) << i;
    if (!turns) {
      EXPECT_LT((upper - lower - high + low).norm(), 0.01) << i;
    }
  }
  EXPECT_TRUE(projection_volume({}, Motion::translation(Vec3::UnitX(), 1)).empty());
}

TEST_F(Views, TellMotionsFromPoses) {
  const Pose from{{}, Vec3(1, 2, 3)};
  const Pose beside{{}, Vec3(1, 2.5, 3)};
  const auto straight = motion_between(from, beside, 0.1);
  ASSERT_TRUE(straight);
  EXPECT_LT((straight->axis - Vec3::UnitY()).norm(), 1e-12);
  const Pose turned{Rotation{0.9, 0, 0, 0.1}.normalized(), from.translation};
  const auto turn = motion_between(from, turned, 0.1);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->kind, Motion::Kind::Rotation);
  EXPECT_LT((turn->axis - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_FALSE(motion_between(from, from, 0.1));
}

/// A picture frame that touches a wall and the floor.
class Walls : public testing::Test {
 protected:
  Walls() : document(folder.file("recovery")), toolbox(*document), hand(document, toolbox) {
    write_boxes(folder.file("wall.obj"), {{{-1, 0, 0}, {1, 0.1, 2}}});
    write_boxes(folder.file("frame.obj"), {{{-0.2, -0.02, 0}, {0.2, 0, 0.3}}});
    document.import(folder.file("wall.obj"), "wall", true);
    document.import(folder.file("frame.obj"), "frame");
    PutOperation operation;
    operation.object = "frame";
    operation.start.translation = Vec3(0, -4e-6, 0.05);
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
    document->select_only(document.id("frame"));
    toolbox.take(ToolKind::Push);
  }

  void drag_in_the_constraint_window(const Vec3& by) {
    hand.window = WindowKind::Constraint;
    hand.view =
        constraint_view(*document->snapshot(), document->selection(), std::nullopt, 600, 400);
    const Vec3 grabbed = document.object("frame").centre_of_mass() + Vec3(0.05, -0.02, 0.05);
    hand.drag(hand.px(grabbed), hand.px(grabbed + by), 12);
  }

  TemporaryFolder folder;
  Recorder document;
  Toolbox toolbox;
  Hand hand;
};

TEST_F(Walls, PushGoesAlongTheContactThatIsChosen) {
  ASSERT_EQ(document.object("frame").contacts.size(), 2u);
  int tries = 0;
  while (active_object_contact(document->selection(), *document->snapshot())->contact.normal.z() >
             0.5 &&
         ++tries < 3)
    ASSERT_TRUE(hand.key('v'));
  toolbox.options().settle = false;
  const Vec3 before = document.object("frame").pose.translation;
  drag_in_the_constraint_window(Vec3(0.3, 0, 0.7));
  const Vec3 moved = document.object("frame").pose.translation - before;
  EXPECT_NEAR(moved.x(), 0.3, 0.01) << document.last_text();
  EXPECT_NEAR(moved.z(), 0.7, 0.01);
  EXPECT_NEAR(moved.y(), 0, 1e-4);
  EXPECT_EQ(document.object("frame").state, ObjectState::Held);
  // It hangs on the wall now, which is its only contact; released it falls.
  toolbox.options().settle = true;
  drag_in_the_constraint_window(Vec3(-0.2, 0, 0.1));
  EXPECT_NEAR(document.object("frame").pose.translation.x(), before.x() + 0.1, 0.01);
  EXPECT_NEAR(document.object("frame").pose.translation.z(), before.z(), 0.01);
  EXPECT_EQ(document.object("frame").state, ObjectState::Stable);
  ASSERT_TRUE(document.done(document->undo()));
  ASSERT_TRUE(document.done(document->redo())) << "the journal keeps the wall";
}

TEST_F(Walls, StepsAreInProportionToTheObject) {
  ToolOptions options;
  const Object& frame = document.object("frame");
  EXPECT_NEAR(push_steps(options, frame).first, 0.06 * std::sqrt(0.16 + 0.0004 + 0.09), 1e-9);
  options.steps_by_size = false;
  EXPECT_EQ(push_steps(options, frame), std::pair(0.01, 0.01));
}

}  // namespace
}  // namespace trivet::edit::test
