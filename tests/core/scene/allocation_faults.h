// Counts allocations of this test program, and lets one of them fail.
#pragma once

#include <cstdint>

namespace trivet::test {

/// While it lives, operator new of this thread counts, and throws std::bad_alloc at the n-th call
/// (0: the first; negative: never), once.
class AllocationFault {
 public:
  explicit AllocationFault(std::int64_t n = -1);
  ~AllocationFault();
  AllocationFault(const AllocationFault&) = delete;
  AllocationFault& operator=(const AllocationFault&) = delete;

  std::int64_t num_allocations() const;
  bool has_failed() const;
};

}  // namespace trivet::test
