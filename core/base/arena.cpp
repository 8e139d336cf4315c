#include "core/base/arena.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace trivet {
namespace {

struct Kept {
  explicit Kept(int threads) : num_threads(threads), arena(threads) {}

  const int num_threads;
  tbb::task_arena arena;
  std::atomic<bool> is_used = true;
  Kept* next = nullptr;
};

// Grows only, without a lock, which a child that was forked meanwhile would never get. As long as
// all calls that run at once.
std::atomic<Kept*> first_kept = nullptr;

Kept& take(int num_threads) {
  for (Kept* kept = first_kept; kept; kept = kept->next)
    if (kept->num_threads == num_threads && !kept->is_used.exchange(true)) return *kept;
  Kept* const made = new Kept(num_threads);
  made->next = first_kept;
  while (!first_kept.compare_exchange_weak(made->next, made)) continue;
  return *made;
}

}  // namespace

void run_in_arena(int num_threads, void (*call)(void* context), void* context) {
  // Without workers an arena loses nothing.
  if (num_threads == 1) return tbb::task_arena(1).execute([&] { call(context); });
  // More would be a line of oneTBB's on standard error.
  const int cores = tbb::info::default_concurrency();
  Kept& kept = take(num_threads > 0 ? std::min(num_threads, cores) : cores);
  const struct Release {
    Kept& kept;
    ~Release() { kept.is_used = false; }
  } release{kept};
  kept.arena.execute([&] { call(context); });
}

int num_threads_here() {
  // Slots of an arena may outnumber the threads that are allowed.
  const size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::max(1, std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(allowed)));
}

}  // namespace trivet
