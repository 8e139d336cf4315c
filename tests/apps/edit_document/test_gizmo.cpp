#include <gtest/gtest.h>

#include <cmath>

#include "apps/edit/tools/contact_picking.h"
#include "apps/edit/tools/gizmo.h"
#include "apps/edit/tools/placing.h"
#include "apps/edit/tools/turning.h"

namespace trivet::edit::test {
namespace {

View some_view(bool orthographic) {
  View view;
  view.eye = Vec3(1.5, -2, 1.2);
  view.orthographic = orthographic;
  view.width_px = 800;
  view.height_px = 600;
  return view;
}

TEST(Gizmo, HitsEveryHandleOnItsLines) {
  for (const bool orthographic : {false, true})
    for (const bool turns : {false, true}) {
      const View view = some_view(orthographic);
      const Gizmo gizmo{Vec3(0.1, 0.1, 0), turns};
      int num_met = 0, num_lines = 0;
      for (const GizmoHandle& handle : gizmo.handles())
        for (const auto& [a, b] : gizmo.lines(handle, view)) {
          const Vec3 far = handle.kind == GizmoHandle::Kind::Arrow ? b : Vec3(0.5 * (a + b));
          ++num_lines;
          num_met += gizmo.hit(view, *view.project(far)) == handle;
        }
      EXPECT_GT(num_met, 0.75 * num_lines);  // rings cross each other
      EXPECT_FALSE(gizmo.hit(view, Vec2(3, 3)));
    }
}

TEST(Gizmo, KeepsScreenSizeAtAnyDistance) {
  View view = some_view(false);
  const auto length = [&] {
    double longest = 0;
    for (const auto& [a, b] : Gizmo{}.lines({GizmoHandle::Kind::Arrow, 0}, view))
      longest = std::max(longest, (*view.project(a) - *view.project(b)).norm());
    return longest;
  };
  const double near = length();
  view.eye *= 50;
  EXPECT_NEAR(length() / near, 1, 0.15);
}

TEST(Gizmo, IgnoresArrowSeenEndOn) {
  View view = some_view(true);
  view.eye = Vec3(0, 0, 3);
  view.up = Vec3::UnitY();
  const auto met = Gizmo{}.hit(view, Vec2(400, 300));
  EXPECT_TRUE(!met || met->axis != 2 || met->kind != GizmoHandle::Kind::Arrow);
}

PointerEvent event_at(const View& view, const Vec2& px) {
  PointerEvent event;
  event.view = view;
  event.px = px;
  return event;
}

TEST(Turning, FollowsMouseAroundAxisSeenEndOn) {
  for (const double sign : {1.0, -1.0}) {
    View view = some_view(true);
    view.eye = Vec3(0, 0, 3);
    view.up = Vec3::UnitY();
    const auto at = [&](double deg) {
      const double a = deg * M_PI / 180;
      return event_at(view, Vec2(400 + 100 * std::cos(a), 300 - 100 * std::sin(a)));
    };
    Turning turning(at(0), Vec3::Zero(), Vec3(0, 0, sign));
    double angle = 0;
    for (double deg = 0; deg <= 500; deg += 20) angle = turning.follow(at(deg), 0);
    EXPECT_NEAR(angle, sign * 500, 0.02);
    EXPECT_NEAR(turning.follow(at(488), 15), sign * 495, 1e-9);
  }
}

TEST(Turning, FollowsMouseAcrossAxisSeenFromSide) {
  View view = some_view(true);
  view.eye = Vec3(0, -3, 0);
  Turning turning(event_at(view, Vec2(400, 300)), Vec3::Zero(), Vec3::UnitZ());
  // The side that faces the viewer moves right when z turns forwards.
  EXPECT_GT(turning.follow(event_at(view, Vec2(440, 300)), 0), 10);
}

TEST(Placing, RoundsToFewDigits) {
  EXPECT_EQ(rounded(0.123456, 0.004), 0.123);
  EXPECT_EQ(rounded(-7.26, 1), -7);
  EXPECT_EQ(rounded(0.3, 0), 0.3);
}

TEST(ContactPicking, DetectsInsideOfPolygons) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_TRUE(is_inside(Vec2(5, 5), square));
  EXPECT_FALSE(is_inside(Vec2(15, 5), square));
  EXPECT_NEAR(distance_px(Vec2(5, 13), square[3], square[2]), 3, 1e-12);
  EXPECT_NEAR(distance_px(Vec2(13, 14), square[3], square[2]), 5, 1e-12);
}

}  // namespace
}  // namespace trivet::edit::test
