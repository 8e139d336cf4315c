#include "allocation_faults.h"

#include <cstdlib>
#include <new>

namespace {

struct Watch {
  bool on = false, failed = false;
  std::int64_t count = 0, fails_at = -1;
};
thread_local Watch watch;

void* allocate(std::size_t size) {
  if (watch.on && watch.count++ == watch.fails_at) {
    watch.failed = true;
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  if (watch.on && watch.count++ == watch.fails_at) {
    watch.failed = true;
    throw std::bad_alloc();
  }
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Arrays and the forms that do not throw call these.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, alignment);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace trivet::test {

AllocationFault::AllocationFault(std::int64_t n) { watch = {true, false, 0, n}; }
AllocationFault::~AllocationFault() { watch = {}; }
std::int64_t AllocationFault::num_allocations() const { return watch.count; }
bool AllocationFault::has_failed() const { return watch.failed; }

}  // namespace trivet::test
