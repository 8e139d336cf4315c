// The paper's figures of operations and of the load-support list: Fig. 1, 4, 5, 6 and 18.
#include <cmath>

#include "ops/operations/pile.h"
#include "ops/operations/push_stage.h"
#include "ops/operations/turn_stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::BoxOnFloor;
using test::Pile;
using test::push;
using test::Stage;
using test::Table;
using test::turn;
using End = OperationResult::End;

// Fig. 1: object 1 lies on object 2, their normal is N. No motion against N; all motions across and
// along it are free; turns about N go on until blocked, all others are stopped.
TEST(Figure1, AreaContactAllowsMotionsAcrossAndAlongNormal) {
  BoxOnFloor s;  // half extents 0.2, 0.1, 0.3
  s.fix("wall", box_triangles(Vec3(0.05, 1, 1)), {0.26, 0, 1 + 1e-5});
  const auto moved = [&](const Vec3& by) {
    Stage t = s;
    const OperationResult result = t.run(TranslateOperation{{"box"}, by});
    EXPECT_EQ(result.end == End::Reached, result.blocked_by.name.empty());
    return result.moved;
  };
  const double nothing = 1.1 * s.clearance();  // gaps open or close
  EXPECT_LE(moved({0, 0, -0.1}), nothing);
  EXPECT_LE(moved({-0.1, 0, -0.1}), nothing);
  EXPECT_NEAR(moved({-0.3, 0.4, 0}), 0.5, nothing);
  EXPECT_NEAR(moved({0, 0, 0.1}), 0.1, nothing);
  EXPECT_NEAR(moved({0.1, 0, 0}), 0.01, 2 * s.clearance());  // to the wall

  const auto turned = [&](const Vec3& axis, double angle_deg) {
    Stage t = s;
    return t.run(RotateOperation{{"box"}, axis, angle_deg, {}}).turned_deg;
  };
  EXPECT_NEAR(turned(Vec3::UnitX(), 20), 0, 0.01);
  EXPECT_NEAR(turned(Vec3::UnitY(), -20), 0, 0.01);
  EXPECT_NEAR(turned(Vec3(0, 1, 1), 20), 0, 0.01);
  // The corner at (0.2, -0.1) meets the wall at x = 0.21.
  const double expected = (std::atan(0.5) - std::acos(0.21 / std::sqrt(0.05))) * 180 / M_PI;
  EXPECT_NEAR(turned(Vec3::UnitZ(), 90), expected, 0.01);
  EXPECT_NEAR(turned(Vec3::UnitZ(), -90), -expected, 0.01);
}

// Fig. 4a: still in contact, the push goes on.
TEST(Figure4a, PushGoesOnInContact) {
  Table t;
  const double z = t.position("box").z();
  const OperationResult result = t.run(push(3, 4, 0.5));
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_NEAR((t.position("box") - Vec3(-0.2, 0.4, z)).norm(), 0, 1.1 * t.clearance());
  EXPECT_NEAR(result.moved, 0.5, 1.1 * t.clearance());
  EXPECT_EQ(t.at("box").state, ObjectState::Stable);
  EXPECT_LE(result.num_motions, 4);
}

// Fig. 4b: the step is higher than the threshold: back to the point of collision.
TEST(Figure4b, PushStopsAtHighStep) {
  Table t;
  t.fix("step", box_triangles(Vec3(0.2, 0.5, 0.01)), {0.2, 0, t.top() + 0.01 + 1e-5});
  PushOperation o = push(1, 0, 0.5);
  o.step_up = 0.019;
  const OperationResult result = t.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Step);
  EXPECT_EQ(result.blocked_by.name, "step");
  EXPECT_NEAR(result.blocked_at.x(), 0, 2 * t.clearance());
  EXPECT_NEAR(t.position("box").x(), -0.1, 2.1 * t.clearance());
  EXPECT_EQ(t.at("box").state, ObjectState::Stable);
}

// Fig. 4c: lower than the threshold: raised onto it, and on.
TEST(Figure4c, PushClimbsLowStep) {
  Table t;
  t.fix("step", box_triangles(Vec3(0.2, 0.5, 0.01)), {0.2, 0, t.top() + 0.01 + 1e-5});
  const double z = t.position("box").z();
  PushOperation o = push(1, 0, 0.7);
  o.step_up = 0.021;
  const OperationResult result = t.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_NEAR(t.position("box").x(), 0.2, 2 * t.clearance());
  EXPECT_NEAR(t.position("box").z(), z + 0.02 + 1e-5, 2 * t.clearance());
  EXPECT_EQ(test::loads_text(t.scene), "table; box on step; step under box; ");
}

// Fig. 4d: contact lost by less than the threshold: lowered until there is contact.
TEST(Figure4d, PushDescendsLowEdge) {
  Table t(true);
  ASSERT_TRUE(t.run(PutOperation{{"box"}, Pose{{}, Vec3(-0.65, 0, 1)}}).ok());
  const double z = t.position("box").z();
  PushOperation o = push(1, 0, 0.8);
  o.step_down = 0.021;
  const OperationResult result = t.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_NEAR(t.position("box").x(), 0.15, 2 * t.clearance());
  EXPECT_NEAR(t.position("box").z(), z - 0.02 - 1e-5, 2 * t.clearance());
}

// Fig. 4e: by more: pulled back to the end of the contact.
TEST(Figure4e, PushStaysAtEndOfContact) {
  Table t;
  PushOperation o = push(1, 0, 3);
  o.settle = false;
  const OperationResult result = t.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Edge);
  EXPECT_NEAR(t.position("box").x(), 1.1, 10 * t.clearance());  // its last edge on the table's edge
  EXPECT_EQ(t.at("box").state, ObjectState::Held);  // no other contact would keep it there
}

// Fig. 5, example 1: an area contact, the axis is its normal.
TEST(Figure5, TurnsAreaContactAboutNormal) {
  BoxOnFloor s;
  const Vec3 before = s.position("box");
  TurnOperation o = turn(TurnOperation::About::Normal, 30);
  OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_EQ(result.turned_deg, 30);
  EXPECT_NEAR((s.position("box") - before).norm(), 0, s.clearance());  // about the contact's centre
  EXPECT_NEAR(s.at("box").pose.rotation.matrix()(0, 0), std::cos(M_PI / 6), 1e-14);
  EXPECT_EQ(s.at("box").state, ObjectState::Stable);

  o.centre = Vec3(1, 0, 0);
  o.angle_deg = 180;
  result = s.run(o);
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_EQ(result.num_motions, 2);
  EXPECT_NEAR((s.position("box") - Vec3(2, 0, before.z())).norm(), 0, s.clearance());
}

// Fig. 5, example 2: a line, an edge of the contact; when released, it falls back.
TEST(Figure5, TurnsLineContactAboutLine) {
  BoxOnFloor s;
  TurnOperation o = turn(TurnOperation::About::Line, 30);
  o.point = Vec3(0.2, 0, 0);
  const double clearance = s.position("box").z() - 0.3;
  OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  // About the edge x = 0.2: the box tilts towards +x, and its centre rises.
  const double c = std::cos(M_PI / 6), si = 0.5;
  EXPECT_NEAR(s.position("box").x(), 0.2 - 0.2 * c + 0.3 * si, 2 * s.clearance());
  EXPECT_NEAR(s.position("box").z(), clearance + 0.2 * si + 0.3 * c, 2 * s.clearance());
  EXPECT_EQ(s.at("box").state, ObjectState::Held);
  ASSERT_EQ(s.at("box").contacts.size(), 1u);
  EXPECT_EQ(s.at("box").contacts[0].contact.type, ContactType::Line);

  // A line contact: on by 30 degrees, past its balance (33.7), and released: it falls on its side.
  o.point.reset();
  o.axis = Vec3::UnitY();
  o.settle = true;
  result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(s.position("box").z(), 0.2, 1e-5);
  EXPECT_EQ(s.at("box").state, ObjectState::Stable);
}

// Fig. 5, example 3: a point, and any axis through it.
TEST(Figure5, TurnsPointContactAboutAnyAxis) {
  BoxOnFloor s;
  const double clearance = s.position("box").z() - 0.3;
  TurnOperation o = turn(TurnOperation::About::Point, 20);
  o.point = Vec3(0.2, 0.1, 0);
  o.axis = Vec3(-1, 1, 0);  // tilts it towards (1, 1)
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  const Vec3 corner = s.at("box").world_from_object().apply(Vec3(0.2f, 0.1f, -0.3f));
  EXPECT_NEAR((corner - Vec3(0.2f, 0.1f, clearance)).norm(), 0, 2 * s.clearance());
  ASSERT_EQ(s.at("box").contacts.size(), 1u);
  EXPECT_EQ(s.at("box").contacts[0].contact.type, ContactType::Point);
  EXPECT_EQ(s.at("box").state, ObjectState::Held);
}

// Fig. 6: two objects on a table, one with a third on it; and the hull of each contact.
TEST(Figure6, ListsLoadsAndSupports) {
  Pile s;
  EXPECT_EQ(test::loads_text(s.scene),
            "table on floor under a under b; a on table; b on table under c; c on b; "
            "beside on floor; ");
  // Seen from above, the corners of the smaller face, where it lies.
  const auto lies_in = [&](const std::string& load, const Vec2& at, double half) {
    for (const ObjectContact& entry : s.at(load).contacts) {
      if (!holds_up(entry.contact)) continue;
      EXPECT_EQ(entry.contact.type, ContactType::Area);
      ASSERT_EQ(entry.contact.hull.size(), 4u);
      for (const Vec3& corner : entry.contact.hull) {
        EXPECT_NEAR(std::abs(corner.x() - at.x()), half, 1e-7) << load;
        EXPECT_NEAR(std::abs(corner.y() - at.y()), half, 1e-7) << load;
      }
    }
  };
  lies_in("table", {0, 0}, 0.5);
  lies_in("a", {-0.2, 0}, 0.1);
  lies_in("b", {0.2, 0}, 0.1);
  lies_in("c", {0.2, 0.05}, 0.05);
}

// Fig. 18: an edge of a contact is chosen, and the object is turned about it by an angle.
TEST(Figure18, TiltsAboutChosenEdge) {
  for (const double angle : {35.0, 90.0}) {
    Stage s;
    s.fix("table", box_triangles(Vec3(1, 1, 0.25)), {0, 0, 0.25 + 1e-5});
    s.put("box", box_triangles(Vec3(0.1, 0.15, 0.02)), {0.3, 0.2, 1});  // a book
    const double low = s.position("box").z() - 0.02;
    TurnOperation o = turn(TurnOperation::About::Line, angle);
    o.point = Vec3(0.3, 0.2 - 0.15, low);  // its front edge
    const OperationResult result = s.run(o);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_NEAR(result.turned_deg, angle, angle < 90 ? 0 : 0.01);  // then its back touches
    // The centre goes round the edge, up and to the front.
    const double c = std::cos(angle * M_PI / 180), si = std::sin(angle * M_PI / 180);
    const Vec3 expected(0.3, 0.05 + 0.15 * c - 0.02 * si, low + 0.15 * si + 0.02 * c);
    EXPECT_NEAR((s.position("box") - expected).norm(), 0, 2 * s.clearance());
    ASSERT_EQ(s.at("box").contacts.size(), 1u);
    const Contact& contact = s.at("box").contacts[0].contact;
    EXPECT_EQ(contact.type, angle < 90 ? ContactType::Line : ContactType::Area);
    for (const Vec3& p : contact.hull) EXPECT_LE(p.y(), 0.05 + 1e-6);
    EXPECT_EQ(s.at("box").state, angle < 90 ? ObjectState::Held : ObjectState::Stable);
  }
}

}  // namespace
}  // namespace trivet
