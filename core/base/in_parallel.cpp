// Compiled without the thread sanitizer, as the library is: it would see only one half of how the
// library's tasks are ordered.
#include "core/base/in_parallel.h"

#include <tbb/parallel_for.h>

namespace trivet {

void run_in_parallel(size_t count, void (*call)(void* context, size_t i), void* context) {
  tbb::parallel_for(size_t{0}, count, [=](size_t i) { call(context, i); });
}

}  // namespace trivet
