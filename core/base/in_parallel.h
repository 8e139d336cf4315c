// Loops over independent items by all threads of the current arena.
#pragma once

#include <cstddef>

#include "core/base/task_order.h"

namespace trivet {

/// Calls call(context, i) for all i below `count`; see in_parallel().
void run_in_parallel(size_t count, void (*call)(void* context, size_t i), void* context);

/// f(0) to f(count - 1), by the threads of the current arena. All begins after the call, and ends
/// before its return.
template <class F>
void in_parallel(size_t count, F f) {
  struct Loop {
    F& f;
    TaskOrder begin, end;
  } loop{f, {}, {}};
  loop.begin.give();
  const auto call = [](void* context, size_t i) {
    Loop& here = *static_cast<Loop*>(context);
    here.begin.take();
    here.f(i);
    here.end.give();
  };
  run_in_parallel(count, call, &loop);
  loop.end.take();
}

}  // namespace trivet
