// Freed memory of a program. Libraries leave these limits to their host.
#pragma once

#include <malloc.h>

namespace trivet {

/// Lets this process keep what it frees, up to 64 MiB: solvers of linear programs take up to 1 MiB
/// each, which glibc would give back to the system and ask for again: a twentieth of a PUT.
inline void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace trivet
