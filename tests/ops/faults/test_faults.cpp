// Memory that runs out in the middle of an operation: the scene is as before or as after, never
// between. TRIVET_TEST_EFFORT=17 runs 1,000 sequences and fails nearly every allocation of each.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>

#include "core/scene/allocation_faults.h"
#include "core/scene/fingerprint.h"
#include "ops/faults/random_piles.h"
#include "ops/operations/live_move.h"
#include "ops/operations/perform.h"
#include "ops/session/session.h"
#include "support/effort.h"

namespace trivet {
namespace {

using test::AllocationFault;
using test::chosen;
using test::push_of;
using test::random_operation;
using test::random_scene;

/// Runs `work(scene)` with each of the chosen allocations failing. @return how many failed.
template <class Work>
int expect_all_or_nothing(const Scene& start, const Work& work, test::Random& random) {
  const std::uint64_t before = fingerprint(start);
  Scene whole = start;
  std::int64_t num_allocations = 0;
  {
    const AllocationFault count;
    work(whole);
    num_allocations = count.num_allocations();
  }
  const std::uint64_t after = fingerprint(whole);
  int num_failed = 0;
  const std::int64_t most = std::max(60, test::with_effort(60));
  for (const std::int64_t n : chosen(num_allocations, most, random)) {
    Scene scene = start;
    {
      const AllocationFault fault(n);
      try {
        work(scene);
      } catch (const std::bad_alloc&) {
        ++num_failed;
      }
    }
    const std::uint64_t now = fingerprint(scene);
    EXPECT_TRUE(now == before || now == after) << "allocation " << n;
    EXPECT_TRUE(scene.is_consistent()) << "allocation " << n;
    if (testing::Test::HasFailure()) return num_failed;
  }
  return num_failed;
}

TEST(OperationFaults, LeaveSceneAsBeforeOrAsAfter) {
  int num_failed = 0;
  for (int i = 0; i < test::with_effort(60) && !HasFailure(); ++i) {
    SCOPED_TRACE("sequence " + std::to_string(i));
    test::Random random(100 + i);
    const Scene start = random_scene(random);
    const Operation operation = random_operation(random);
    SCOPED_TRACE(op_name(operation));
    num_failed += expect_all_or_nothing(
        start, [&](Scene& scene) { perform(scene, operation); }, random);
  }
  EXPECT_GT(num_failed, 500);
}

TEST(OperationFaults, LeaveSceneOfInteractiveMoveAsBeforeOrAsAfter) {
  int num_failed = 0;
  for (int i = 0; i < test::with_effort(15) && !HasFailure(); ++i) {
    SCOPED_TRACE("drag " + std::to_string(i));
    test::Random random(300 + i);
    const Scene start = random_scene(random);
    const auto drag = [](Scene& scene) {
      LiveMove live(scene, push_of("box0", false, Vec2(1, 0), 0), {});
      for (const double x : {0.02, 0.05, 0.1}) live.follow(Vec3(x, 0.03, 0));
      live.finish(scene);
    };
    num_failed += expect_all_or_nothing(start, drag, random);
  }
  EXPECT_GT(num_failed, 50);
}

// A session that failed goes on as if nothing had been asked for.
TEST(OperationFaults, LeaveSessionUsable) {
  test::Random random(7);
  const Scene start = random_scene(random);
  const PushOperation push = push_of("box0", false, Vec2(1, 0.3), 0.05);
  Session whole(start, {}, {});
  whole.perform(push);
  const std::uint64_t after = fingerprint(whole.scene());
  for (std::int64_t n = 0; n < 2000; n += 7) {
    Session session(start, {}, {});
    bool failed = false;
    {
      const AllocationFault fault(n);
      try {
        session.perform(push);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
    }
    if (failed) {
      ASSERT_EQ(fingerprint(session.scene()), fingerprint(start)) << n;
      ASSERT_EQ(session.num_done(), 0u) << n;
      session.perform(push);
    }
    ASSERT_EQ(fingerprint(session.scene()), after) << n;
    ASSERT_TRUE(session.undo()) << n;
    ASSERT_EQ(fingerprint(session.scene()), fingerprint(start)) << n;
  }
}

}  // namespace
}  // namespace trivet
