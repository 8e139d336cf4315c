// Every allocation of a change fails once: the scene is as before or as after, never between.
#include <gtest/gtest.h>

#include <new>

#include "allocation_faults.h"
#include "core/scene/transaction.h"
#include "random_changes.h"
#include "support/effort.h"

namespace trivet {
namespace {

using test::all_answers;
using test::AllocationFault;

Scene random_scene(unsigned seed, int num_changes) {
  Scene scene;
  test::RandomChanges changes(seed);
  Transaction transaction(scene);
  for (int i = 0; i < num_changes; ++i) changes.apply(transaction);
  transaction.commit();
  return scene;
}

// A transaction with some changes, and another one within.
void run(Scene& scene, unsigned seed, SceneChange* undo) {
  test::RandomChanges changes(seed);
  Transaction outer(scene);
  for (int i = 0; i < 3; ++i) changes.apply(outer);
  {
    Transaction inner(scene);
    for (int i = 0; i < 2; ++i) changes.apply(inner);
    if (seed % 3) inner.commit();
  }
  changes.apply(outer);
  *undo = outer.commit();
}

TEST(SceneFaults, LeaveTheSceneAsBeforeOrAsAfter) {
  int num_faults = 0;
  const int num_seeds = test::with_effort(60);
  for (int seed = 0; seed < num_seeds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const Scene start = random_scene(seed, seed % 40);
    const std::string before = all_answers(start);
    Scene whole = start;
    SceneChange undo;
    run(whole, seed, &undo);
    const std::string after = all_answers(whole);
    bool failed = true;
    for (std::int64_t n = 0; failed && !HasFailure(); ++n) {
      Scene scene = start;
      {
        const AllocationFault fault(n);
        try {
          run(scene, seed, &undo);
        } catch (const std::bad_alloc&) {
        }
        failed = fault.has_failed();
      }
      num_faults += failed;
      ASSERT_EQ(all_answers(scene), failed ? before : after) << "allocation " << n;
      ASSERT_TRUE(scene.is_consistent()) << "allocation " << n;
      if (!failed) break;
      // The scene can be used as if nothing had happened. Generations are not taken back.
      run(scene, seed, &undo);
      ASSERT_TRUE(scene.is_consistent());
    }
  }
  std::printf("%d allocations failed\n", num_faults);
  EXPECT_GT(num_faults, 20 * num_seeds);
}

TEST(SceneFaults, AddAndRemoveWithoutATransactionAreWholeOrNothing) {
  int num_faults = 0;
  for (int seed = 1; seed < 20; ++seed) {
    const Scene start = random_scene(seed, 65);
    const ObjectId first = start.ids().front();
    Object object;
    object.name = "a name that is too long to be stored within";
    for (const bool adds : {false, true}) {
      for (std::int64_t n = 0;; ++n) {
        Scene scene = start;
        bool failed = false;
        {
          const AllocationFault fault(n);
          try {
            adds ? (void)scene.add(object) : scene.remove(first);
          } catch (const std::bad_alloc&) {
          }
          failed = fault.has_failed();
        }
        ASSERT_TRUE(scene.is_consistent());
        if (!failed) break;
        ++num_faults;
        ASSERT_EQ(all_answers(scene), all_answers(start));
      }
    }
  }
  EXPECT_GT(num_faults, 19);
}

TEST(SceneFaults, RollbackCommitAndExchangeAllocateNothing) {
  for (int seed = 0; seed < 20; ++seed) {
    Scene scene = random_scene(seed, 30);
    test::RandomChanges changes(seed + 1);
    const std::string before = all_answers(scene);
    auto outer = std::make_unique<Transaction>(scene);
    for (int i = 0; i < 10; ++i) changes.apply(*outer);
    for (const bool commits : {true, false}) {
      auto inner = std::make_unique<Transaction>(scene);
      for (int i = 0; i < 10; ++i) changes.apply(*inner);
      const AllocationFault fault;
      if (commits) inner->commit();
      inner.reset();
      EXPECT_EQ(fault.num_allocations(), 0);
    }
    const std::string after = all_answers(scene);
    {
      const AllocationFault fault;
      SceneChange change = outer->commit();
      outer.reset();
      scene.exchange(change);
      scene.exchange(change);
      scene.exchange(change);
      EXPECT_EQ(fault.num_allocations(), 0);
    }
    EXPECT_EQ(all_answers(scene), before);
    EXPECT_NE(after, before);
    outer = std::make_unique<Transaction>(scene);
    for (int i = 0; i < 10; ++i) changes.apply(*outer);
    {
      const AllocationFault fault;
      outer.reset();
      EXPECT_EQ(fault.num_allocations(), 0);
    }
    EXPECT_EQ(all_answers(scene), before);
  }
}

}  // namespace
}  // namespace trivet
