// Limits for the number of threads of loops.
#pragma once

namespace trivet {

/// Calls call(context) in an arena of its own; see in_arena().
void run_in_arena(int num_threads, void (*call)(void* context), void* context);

/// f(), whose loops (in_parallel.h) have `num_threads` threads, or one per core if that is 0 or
/// less. Threads that end have to come here before they start a loop: oneTBB 2021 loses 7 to 9 kB
/// of every arena with workers that ends, that of a thread, too
/// (https://github.com/uxlfoundation/oneTBB/issues/967). These arenas are kept, and used again.
template <class F>
void in_arena(int num_threads, F f) {
  const auto call = [](void* context) { (*static_cast<F*>(context))(); };
  run_in_arena(num_threads, call, &f);
}

/// Threads that a loop has here at most: cores, those of the arena, or as tbb::global_control says.
int num_threads_here();

}  // namespace trivet
