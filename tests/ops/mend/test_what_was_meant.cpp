// Supports that poses mean where one is far off, or where two hold each other.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"

namespace trivet::test {
namespace {

constexpr double kRoom = 1.2e-6;  // metres above and below the plank in the slot

// A slot along y, through a block.
Mesh slotted_block() {
  const double slot = 0.01 + kRoom;
  // Corners of the outline and of the slot, counterclockwise seen from the front (-y).
  const std::array<Vec2, 4> outer{Vec2(-0.05, -0.05), {0.05, -0.05}, {0.05, 0.05}, {-0.05, 0.05}};
  const std::array<Vec2, 4> inner{Vec2(-0.03, -slot), {0.03, -slot}, {0.03, slot}, {-0.03, slot}};
  std::vector<Triangle> triangles;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  const auto front = [](const Vec2& p) { return Vec3(p.x(), -0.05, p.y()); };
  const auto back = [](const Vec2& p) { return Vec3(p.x(), 0.05, p.y()); };
  for (size_t i = 0; i < 4; ++i) {
    const size_t j = (i + 1) % 4;
    quad(front(outer[i]), front(outer[j]), front(inner[j]), front(inner[i]));
    quad(back(outer[j]), back(outer[i]), back(inner[i]), back(inner[j]));
    quad(front(outer[j]), front(outer[i]), back(outer[i]), back(outer[j]));
    quad(front(inner[i]), front(inner[j]), back(inner[j]), back(inner[i]));
  }
  return weld(triangles);
}

bool rests_on(const Scene& scene, ObjectId id, ObjectId on) {
  const auto& contacts = scene.at(id).contacts;
  return std::any_of(contacts.begin(), contacts.end(), [&](const ObjectContact& c) {
    return c.with.is_object() && c.with.object() == on;
  });
}

// The block hangs on the plank, and the plank lies in the block: each rests, and both float over
// the tilted board, in the way of the board as it was meant to lie.
TEST(HeldByEachOther, TheyMakeWayForWhatWasMeantToCarryThem) {
  Boxes s;
  const ObjectId board =
      s.add("board", {0.5, 0.3, 0.02}, {0, 0, 0.02}, false, turn_about(Vec3::UnitY(), 1));
  const ObjectId block = s.add("block", slotted_block(), {0.3, 0, 0.089});
  const ObjectId plank = s.add("plank", box_of({0.02, 0.15, 0.01}), {0.3, 0, 0.089});
  update_contacts(s.scene);
  ASSERT_EQ(s.scene.at(block).state, ObjectState::Stable);
  ASSERT_EQ(s.scene.at(plank).state, ObjectState::Stable);
  MendOptions options;
  options.tolerance = 0.01;
  const MendedScene out = mend_scene(s.scene, options);
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_EQ(out.num_kept, out.num_meant);
  EXPECT_NEAR(s.at(board).z(), 0.02, 1e-5);
  EXPECT_NEAR(s.at(block).z(), 0.09, 2e-5);
  // The slot has no room in which the plank could be let go: it lies on the block then.
  EXPECT_TRUE(rests_on(s.scene, plank, block));
}

// One thing is off by three times what all others are.
TEST(Intent, OfWhatIsSunkByMoreThanTheToleranceIsItsSupport) {
  Boxes s;
  const ObjectId table = s.add("table", {0.5, 0.5, 0.02}, {0, 0, 0.7}, true);
  const ObjectId keyboard = s.add("keyboard", {0.2, 0.08, 0.012}, {0, 0, 0.727});
  update_contacts(s.scene);
  const Intent intent = infer_intent(s.scene, 0.002);
  const ObjectIntent& meant = *intent.find(keyboard);
  ASSERT_EQ(meant.on.size(), 1u);
  EXPECT_TRUE(meant.on[0].on.is_object() && meant.on[0].on.object() == table);
  EXPECT_NEAR(meant.gap, -0.005, 1e-8);
}

TEST(Intent, OfWhatHangsFarAboveStaysTheFloor) {
  Boxes s;
  s.add("shelf", {0.5, 0.5, 0.02}, {0, 0, 0.7}, true);
  const ObjectId box = s.add("box", {0.05, 0.05, 0.05}, {0.7, 0, 0.8});
  const Intent intent = infer_intent(s.scene, 0.002);
  ASSERT_EQ(intent.find(box)->on.size(), 1u);
  EXPECT_TRUE(intent.find(box)->on[0].on.is_floor());
  EXPECT_NEAR(intent.find(box)->gap, 0.75, 1e-8);
}

}  // namespace
}  // namespace trivet::test
