// PUT from several starts that are tried at once.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "bins.h"
#include "core/base/arena.h"
#include "core/scene/transaction.h"
#include "ops/detect/detector.h"

namespace trivet::test {
namespace {

/// A PUT whose trials end as told by the number of their start, whichever comes first.
struct ToldByNumber {
  enum class End { Stands, AcrossGap, Leaves, Topples, Blocked, Cancelled };

  static constexpr int kTries = 12;
  Scene scene;
  ObjectId id = scene.add(object_of("o", box_triangles({0.1, 0.1, 0.1})));
  PutOperation put{{"o"}, {{}, Vec3(0, 0, 1)}};
  std::function<End(int number)> end;
  /// Called before either.
  std::function<void(int number, Interrupt&)> settles = {}, comes_to_rest = {};

  int number_of(const Pose& start) const {
    for (int n = 1; n <= 2 * kTries; ++n)
      for (const double part : {1.0, 0.5, 0.25, 0.0}) {
        const Pose tried = start_to_try(scene.at(id), put, n, part).start;
        if (tried.translation == start.translation && tried.rotation.z == start.rotation.z)
          return n;
      }
    return 0;
  }

  OperationResult commit(Transaction& inner, const MovePlan& plan) const {
    const Pose start = plan.result.steps.back().pose_after;
    const int number = number_of(start);
    const End how = end(number);
    if (how == End::Blocked) return blocked();
    if (how == End::Topples) {
      OperationResult out = topples();
      // Start 9 topples with the fewest.
      out.refusal->objects.resize(1 + static_cast<size_t>(std::abs(number - 9)));
      return out;
    }
    OperationResult out;
    if (how == End::Cancelled) {
      out = topples();
      out.status = OperationResult::Status::Cancelled;
      return out;
    }
    const double aside = how == End::Leaves ? 2 : 0;
    inner.edit(id, [&](Object& object) {
      object.pose = {start.rotation, start.translation + Vec3(aside, 0, 0)};
      object.placed = true;
    });
    inner.set_contacts(id, {{Support::floor(), {}, how == End::AcrossGap, true}});
    return out;
  }

  /// All that a user sees, and the scene's bits.
  std::string run(int num_threads) {
    OperationRun run({}, {});
    PutSteps steps{[&](const Scene& there, const PutOperation& o, OperationRun& own) {
                     if (settles) settles(number_of(o.start), own.interrupt);
                     return plan_at_start(there, o, own);
                   },
                   [&](Transaction& inner, const MovePlan& plan, Budget, OperationRun& own) {
                     const Pose start = plan.result.steps.back().pose_after;
                     if (comes_to_rest) comes_to_rest(number_of(start), own.interrupt);
                     return commit(inner, plan);
                   },
                   num_threads};
    Transaction transaction(scene);
    const OperationResult result = put_by_tries(transaction, id, put, steps, Budget{120}, run);
    std::string out = std::to_string(static_cast<int>(result.status)) + result.reason();
    if (result.tried) out += " try " + std::to_string(result.tried->number);
    EXPECT_TRUE(scene.is_consistent());
    return out + snapshot(scene);
  }
};

TEST(Tries, EndAlikeHoweverManyAreTriedAtOnce) {
  using End = ToldByNumber::End;
  std::mt19937 random(7);
  std::vector<std::vector<End>> all;
  for (int last = 2; last <= 24; ++last)
    for (const End end : {End::Stands, End::AcrossGap, End::Cancelled}) {
      all.emplace_back(25, End::Topples);
      all.back()[static_cast<size_t>(last)] = end;
    }
  // The first one never just stands.
  for (int k = 0; k < 200; ++k) {
    all.emplace_back();
    for (int n = 0; n <= 24; ++n) {
      const int kind = std::uniform_int_distribution(0, 19)(random);
      all.back().push_back(kind == 0                ? End::Stands
                           : kind == 1              ? End::AcrossGap
                           : kind == 2 && k % 4 < 2 ? End::Leaves
                           : kind < 6               ? End::Blocked
                                                    : End::Topples);
    }
    all.back()[1] = k % 3 ? End::Topples : End::AcrossGap;
  }
  int num_late = 0;
  for (const std::vector<End>& ends : all) {
    std::string expected;
    for (const int num_threads : {1, 2, 3, 16}) {
      ToldByNumber told;
      add_at(told.scene, "bin", bin(1.5, 0.9, 0.01), {0, 0, 1e-4}, true);
      told.end = [&](int number) { return ends[static_cast<size_t>(number)]; };
      const std::string is = told.run(num_threads);
      if (num_threads == 1)
        expected = is;
      else
        EXPECT_EQ(is, expected) << num_threads;
      num_late += is.find("try 1") != std::string::npos;
    }
  }
  EXPECT_GT(num_late, 100) << "of starts that are tried at once";
}

// The others begin on other threads while the first start still settles, or still comes to rest.
TEST(Tries, BeginOthersWhileTheFirstTakesLong) {
  using End = ToldByNumber::End;
  std::mt19937 random(8);
  for (int k = 0; k < 24; ++k) {
    std::vector<End> ends{End::Topples};
    const bool settles_long = k % 2 == 0;
    const auto any = [&] {
      constexpr End kAll[] = {End::Stands, End::AcrossGap, End::Leaves, End::Topples, End::Blocked};
      return kAll[std::uniform_int_distribution(0, 4)(random)];
    };
    for (int n = 1; n <= 24; ++n) ends.push_back(any());
    std::string expected;
    for (const int num_threads : {1, 2, 3}) {
      ToldByNumber told;
      add_at(told.scene, "bin", bin(1.5, 0.9, 0.01), {0, 0, 1e-4}, true);
      std::atomic<bool> is_second_begun = num_threads == 1;
      const auto wait = [&](Interrupt& interrupt) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (!is_second_begun && std::chrono::steady_clock::now() < end) interrupt.reason();
        EXPECT_TRUE(is_second_begun);
      };
      told.end = [&](int number) { return ends[static_cast<size_t>(number)]; };
      told.settles = [&](int number, Interrupt& interrupt) {
        if (number > 1) is_second_begun = true;
        // Long enough for a copy of the scene.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (number == 1 && settles_long) wait(interrupt);
      };
      told.comes_to_rest = [&](int number, Interrupt& interrupt) {
        if (number == 1 && !settles_long) wait(interrupt);
      };
      const std::string is = told.run(num_threads);
      if (num_threads == 1)
        expected = is;
      else
        EXPECT_EQ(is, expected) << num_threads;
    }
  }
}

// A trial that runs beside the one that is taken is stopped, not waited for.
TEST(Tries, StopThoseThatAreNotNeeded) {
  ToldByNumber told;
  told.end = [](int number) {
    return number == 4 ? ToldByNumber::End::Stands : ToldByNumber::End::Topples;
  };
  std::atomic<bool> has_waited_in_vain = false;
  OperationRun run({}, {});
  const auto commit = [&](Transaction& inner, const MovePlan& plan, Budget, OperationRun& own) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    if (told.number_of(plan.result.steps.back().pose_after) > 4)
      while (!own.interrupt.reason() && !has_waited_in_vain)
        has_waited_in_vain = std::chrono::steady_clock::now() > end;
    return told.commit(inner, plan);
  };
  Transaction transaction(told.scene);
  const OperationResult result =
      put_by_tries(transaction, told.id, told.put, {plan_at_start, commit, 2}, Budget{120}, run);
  ASSERT_TRUE(result.ok() && result.tried);
  EXPECT_EQ(result.tried->number, 4);
  EXPECT_FALSE(has_waited_in_vain);
  EXPECT_FALSE(run.interrupt.reason()) << "the operation goes on";
}

TEST(Tries, FillBinAlikeByAnyNumberOfThreads) {
  std::string expected, poses;
  int num = 0;
  in_arena(1, [&] { num = num_in_bin(30, 12, expected); });
  for (const int num_threads : {2, 4}) {
    in_arena(num_threads, [&] { EXPECT_EQ(num_in_bin(30, 12, poses), num); });
    EXPECT_EQ(poses, expected);
  }
}

// Each thread has a detector of its own, whose work counts as if there were one thread.
TEST(Tries, CountTheSameWorkByAnyNumberOfThreads) {
  std::string expected, poses;
  Detector alone;
  in_arena(1, [&] { num_in_bin(30, 12, expected, &alone); });
  for (const int num_threads : {2, 4}) {
    Detector detector;
    in_arena(num_threads, [&] { num_in_bin(30, 12, poses, &detector); });
    EXPECT_EQ(poses, expected);
    EXPECT_EQ(detector.work().num_queries, alone.work().num_queries);
    EXPECT_EQ(detector.work().node_pairs, alone.work().node_pairs);
  }
}

}  // namespace
}  // namespace trivet::test
