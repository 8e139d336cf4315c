// PUT on all kinds of things.

#include <gtest/gtest.h>

#include <cstdio>

#include "arrangements.h"
#include "ops/put.h"
#include "support/effort.h"

namespace trivet {
namespace {

/// Every one must end ok.
void expect_all_ok(test::MakeArrangement make, int num) {
  int num_ok = 0, num_motions = 0, most = 0;
  num = test::with_effort(num);
  for (int i = 0; i < num; ++i) {
    SCOPED_TRACE("arrangement " + std::to_string(i));
    test::Arrangement a = make(i);
    const OperationResult result = test::put_twice(a);
    EXPECT_TRUE(result.ok()) << a.name << ' ' << i << ": " << result.reason;
    num_ok += result.ok();
    num_motions += result.num_motions;
    most = std::max(most, result.num_motions);
  }
  std::printf("%d of %d ok, %.1f motions in the mean, %d at most\n", num_ok, num,
              1.0 * num_motions / num, most);
}

TEST(Put, OnTheFloor) { expect_all_ok(test::on_floor, 48); }
TEST(Put, AStickOnASaucer) { expect_all_ok(test::stick_on_saucer, 16); }
TEST(Put, IntoABowl) { expect_all_ok(test::into_bowl, 32); }
TEST(Put, ATorusOverAPeg) { expect_all_ok(test::torus_over_peg, 20); }
TEST(Put, OnTwoSupportsOfDifferentHeights) { expect_all_ok(test::on_two_heights, 32); }
TEST(Put, AgainstAWall) { expect_all_ok(test::against_wall, 32); }
TEST(Put, IntoAWedge) { expect_all_ok(test::into_wedge, 48); }
TEST(Put, AHookOnABar) { expect_all_ok(test::hook_on_bar, 16); }
TEST(Put, OntoABall) { expect_all_ok(test::onto_ball, 32); }
TEST(Put, OntoASlope) { expect_all_ok(test::onto_slope, 48); }

}  // namespace
}  // namespace trivet
