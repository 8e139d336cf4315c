// Splits work into contiguous parts whose results can be joined in a fixed order.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace trivet {

/// f(0) to f(count - 1), by the threads of the current arena. The thread sanitizer is told what the
/// library promises, as the library itself is not compiled for it: all begins after the call, and
/// ends before its return.
template <class F>
void in_parallel(size_t count, F f) {
#ifdef __SANITIZE_THREAD__
  char begin = 0, end = 0;
  __tsan_release(&begin);
  tbb::parallel_for(size_t{0}, count, [&](size_t i) {
    __tsan_acquire(&begin);
    f(i);
    __tsan_release(&end);
  });
  __tsan_acquire(&end);
#else
  tbb::parallel_for(size_t{0}, count, f);
#endif
}

/// Smaller parts are not worth a thread.
inline constexpr size_t kSmallestPart = 1 << 14;

inline size_t num_parts(size_t count, int num_threads) {
  return std::clamp<size_t>(count / kSmallestPart, 1, static_cast<size_t>(num_threads));
}

/// Parts begin at multiples of this.
inline constexpr size_t kPartStep = 64;

/// Calls f(part, first, last) for each of num_parts() parts.
template <class F>
void for_each_part(size_t count, int num_threads, F f) {
  const size_t parts = num_parts(count, num_threads);
  const auto begin = [&](size_t i) {
    return i == parts ? count : count * i / parts / kPartStep * kPartStep;
  };
  const auto run = [&](size_t i) { f(i, begin(i), begin(i + 1)); };
  if (parts == 1) return run(0);
  const int cores = std::min(num_threads, tbb::this_task_arena::max_concurrency());
  tbb::task_arena(cores).execute([&] { in_parallel(parts, run); });
}

}  // namespace trivet
