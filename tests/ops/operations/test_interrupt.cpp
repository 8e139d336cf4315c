// Operations that are cancelled or time out.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ops/base/interrupt.h"
#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"

namespace trivet::test {
namespace {

OperationResult interrupted_put(const RunContext& context) {
  Arrangement a = into_bowl(0);
  const Scene before = a.scene;
  OperationResult result = put(a.scene, a.object, a.start, {}, context);
  EXPECT_FALSE(result.ok());
  EXPECT_EQ(difference(before, a.scene), "");
  EXPECT_NE(result.reason().find("put of \"" + a.scene.at(a.object).name + "\""), std::string::npos)
      << result.reason();
  return result;
}

TEST(Interrupt, CancelledPutKeepsScene) {
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  const OperationResult result = interrupted_put(context);
  EXPECT_EQ(result.status, OperationResult::Status::Cancelled);
  EXPECT_EQ(result.num_motions, 0);
  EXPECT_NE(result.reason().find("was cancelled"), std::string::npos);
}

TEST(Interrupt, TimedOutPutKeepsScene) {
  RunContext context;
  context.time_budget_s = 1e-9;
  const OperationResult result = interrupted_put(context);
  EXPECT_EQ(result.status, OperationResult::Status::OutOfTime);
  EXPECT_NE(result.reason().find("did not end within 1e-09 s"), std::string::npos)
      << result.reason();
}

TEST(Interrupt, CallsOnceAfterItsTime) {
  int num_calls = 0;
  Interrupt interrupt({});
  interrupt.call_after(std::chrono::milliseconds(20), [&] { ++num_calls; });
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
  EXPECT_FALSE(interrupt.reason());
  const bool was_early = std::chrono::steady_clock::now() < end;
  EXPECT_LE(num_calls, was_early ? 0 : 1);
  std::this_thread::sleep_until(end);
  for (int k = 0; k < 3; ++k) EXPECT_FALSE(interrupt.reason());
  EXPECT_EQ(num_calls, 1);
}

TEST(Interrupt, CallsNothingWhereItStopsOrForgets) {
  int num_calls = 0;
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  Interrupt stopped(context), forgetful({});
  for (Interrupt* interrupt : {&stopped, &forgetful})
    interrupt->call_after({}, [&] { ++num_calls; });
  forgetful.call_after({}, nullptr);
  EXPECT_TRUE(stopped.reason());
  EXPECT_FALSE(forgetful.reason());
  EXPECT_EQ(num_calls, 0);
}

// Cancellation at any moment: the whole operation, or no change.
TEST(Interrupt, CancelsFromAnotherThreadAtAnyMoment) {
  int num_cancelled = 0;
  for (int round = 0; round < 40; ++round) {
    Arrangement a = into_bowl(round % 5);
    const Scene before = a.scene;
    std::atomic<bool> cancel = false;
    RunContext context;
    context.cancel = &cancel;
    std::jthread other([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(100 * round));
      cancel = true;
    });
    const OperationResult result = put(a.scene, a.object, a.start, {}, context);
    if (result.ok()) {
      EXPECT_TRUE(a.scene.at(a.object).placed);
    } else {
      num_cancelled += result.status == OperationResult::Status::Cancelled;
      EXPECT_EQ(difference(before, a.scene), "");
    }
  }
  EXPECT_GT(num_cancelled, 0);
}

TEST(Interrupt, AmpleTimeChangesNoResult) {
  Arrangement a = into_bowl(1), b = a;
  const std::atomic<bool> cancel = false;
  RunContext context;
  context.cancel = &cancel;
  context.time_budget_s = 1e9;
  EXPECT_TRUE(put(a.scene, a.object, a.start).ok());
  EXPECT_TRUE(put(b.scene, b.object, b.start, {}, context).ok());
  EXPECT_EQ(difference(a.scene, b.scene), "");
}

TEST(Interrupt, KeepsFirstReason) {
  std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  Interrupt interrupt(context);
  EXPECT_EQ(interrupt.reason(), Interrupt::Reason::Cancelled);
  cancel = false;
  EXPECT_EQ(interrupt.reason(), Interrupt::Reason::Cancelled);
}

}  // namespace
}  // namespace trivet::test
