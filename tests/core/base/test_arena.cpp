#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <barrier>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/arena.h"
#include "core/base/in_parallel.h"

namespace trivet {
namespace {

std::size_t sum_in_parallel(std::size_t count) {
  std::atomic<std::size_t> sum = 0;
  in_parallel(count, [&](std::size_t i) { sum += i; });
  return sum;
}

TEST(Arena, RunsLoopsWholeWithAnyNumberOfThreads) {
  for (const int num_threads : {-1, 0, 1, 2, 3, 64}) {
    std::size_t sum = 0;
    in_arena(num_threads, [&] { sum = sum_in_parallel(1000); });
    EXPECT_EQ(sum, 999u * 1000 / 2) << num_threads;
  }
}

TEST(Arena, PassesExceptionsAndIsUsedAgain) {
  for (int k = 0; k < 10; ++k)
    EXPECT_THROW(in_arena(2, [] { throw std::runtime_error("stop"); }), std::runtime_error);
  std::size_t sum = 0;
  in_arena(2, [&] { in_arena(2, [&] { sum = sum_in_parallel(10); }); });
  EXPECT_EQ(sum, 45u);
}

// All wait for each other: calls that shared the threads of one arena would wait for ever.
TEST(Arena, DoesNotKeepCallersWaitingForEachOther) {
  constexpr int kCallers = 8;
  for (const int num_threads : {0, 1, 2}) {
    std::barrier meet(kCallers);
    std::vector<std::jthread> callers;
    callers.reserve(kCallers);
    for (int k = 0; k < kCallers; ++k)
      callers.emplace_back([&] { in_arena(num_threads, [&] { meet.arrive_and_wait(); }); });
  }
}

double resident_kilobytes() {
  std::ifstream file("/proc/self/statm");
  double whole = 0, resident = 0;
  file >> whole >> resident;
  return 1e-3 * static_cast<double>(sysconf(_SC_PAGESIZE)) * resident;
}

// Threads that start loops by themselves leave 9 kB each; 18 MB here.
TEST(Arena, LeavesNoMemoryOfThreadsThatEnd) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep what is freed";
#endif
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core: arenas have no workers";
  const auto use_threads = [](int count) {
    for (int k = 0; k < count; ++k)
      std::jthread([] { in_arena(2, [] { sum_in_parallel(64); }); }).join();
  };
  use_threads(200);
  const double before = resident_kilobytes();
  use_threads(2000);
  EXPECT_LT(resident_kilobytes() - before, 2000);
}

}  // namespace
}  // namespace trivet
