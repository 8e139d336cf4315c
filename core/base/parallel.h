// Splits work into contiguous parts whose results can be joined in a fixed order.
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/arena.h"
#include "core/base/in_parallel.h"

namespace trivet {

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
  const int cores = std::min(num_threads, num_threads_here());
  in_arena(cores, [&] { in_parallel(parts, run); });
}

}  // namespace trivet
