// The frame of a z-list covers every first contact: its bodies are paired, its place is in the
// image and its depth is its time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/candidates/zlist_frame.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kFrameSeed = 4711;
constexpr double kTurn = 2 * M_PI;

struct Seen {
  double column, row, depth;
};

Seen see(const ZListFrame& frame, const Vec3& world) {
  const Affine at = frame.pixels_from_object(Body());
  const Vec3 p = at.apply(world);
  if (frame.kind == Motion::Kind::Translation) return {p.x(), p.y(), p.z()};
  const double angle = std::atan2(p.y(), p.x());
  return {p.head<2>().norm() - frame.first_radius, p.z(), angle < 0 ? angle + kTurn : angle};
}

bool inside(double x, double low, double high, double slack) {
  return x >= low - slack && x <= high + slack;
}

// Takes the contact's point on the fixed body and the nearest one of the moving body at the start.
void expect_seen(const ZListFrame& frame, const FirstContactQuery& q, const FirstContact& found) {
  const Vec3 touching = found.point + found.gap * found.normal;
  const Vec3 start = moved_point(touching, q.motion, -found.time);
  const bool turning = frame.kind == Motion::Kind::Rotation;
  const Seen a = see(frame, start), b = see(frame, found.point);
  const double slack = frame.growth + 1e-6;
  EXPECT_TRUE(inside(a.column, 0, frame.width, slack) && inside(a.row, 0, frame.height, slack));
  EXPECT_TRUE(inside(b.column, 0, frame.width, slack) && inside(b.row, 0, frame.height, slack));
  EXPECT_NEAR(a.column, b.column, slack);
  EXPECT_NEAR(a.row, b.row, slack);
  const double grown = frame.depth_growth(b.column + frame.first_radius) + 1e-6;

  if (turning && grown >= kTurn) return;  // on the axis
  const double depth = turning && a.depth > kTurn - grown ? a.depth - kTurn : a.depth;
  EXPECT_TRUE(inside(depth, 0, frame.moving_depth, grown));
  const double way = turning ? std::remainder(b.depth - a.depth, kTurn) : b.depth - a.depth;
  EXPECT_LE(frame.time_before(way - grown), found.time);
  EXPECT_GE(frame.time_after(std::max(0.0, way + grown)), found.time);
  EXPECT_LE(way, frame.reach + grown);
}

TEST(ZListFrame, CoversEveryFirstContact) {
  const test::MeshPool pool(kFrameSeed, 12);
  const int num = test::with_effort(6000);
  int num_contacts = 0, num_empty = 0;
  for (int i = 0; i < num; ++i) {
    SCOPED_TRACE(i);
    test::RandomQuery q = i % 2 ? test::random_group_query(pool, kFrameSeed, i / 2)
                                : test::random_query(pool, kFrameSeed, i / 2);
    q.floor = false;
    q.ask([&](const FirstContactQuery& query) {
      const ZListFrame frame = make_zlist_frame(query, query.motion.limit, 8 << i % 7);
      const FirstContact found = first_contact(query);
      num_empty += frame.empty();
      EXPECT_LE(std::max(frame.width, frame.height), 8 << i % 7);
      if (found.status == FirstContact::Status::Free) return found;
      const auto paired = [&](const BodyPair& p) {
        return p.moving == found.moving && p.fixed == found.fixed;
      };
      EXPECT_TRUE(std::any_of(frame.pairs.begin(), frame.pairs.end(), paired)) << q.describe();
      if (frame.empty() || found.status != FirstContact::Status::Contact) return found;
      ++num_contacts;
      expect_seen(frame, query, found);
      return found;
    });
    if (HasFailure()) FAIL() << q.describe();
  }
  EXPECT_GT(num_contacts, num / 6);
  EXPECT_GT(num_empty, num / 50);
}

TEST(ZListFrame, IsEmptyWithoutBodies) {
  const FirstContactQuery query;
  EXPECT_TRUE(make_zlist_frame(query, 1, 64).empty());
}

}  // namespace
}  // namespace trivet
