#include "file_faults.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace {

using Kind = trivet::test::FileFault::Kind;

struct Watch {
  bool on = false, failed = false, is_half_written = false;
  Kind kind = Kind::Once;
  std::int64_t count = 0, fails_at = -1;
};
thread_local Watch watch;

/// True if this call is to fail; then errno says why.
bool fails(bool needs_space) {
  if (!watch.on) return false;
  const std::int64_t n = watch.count++;
  if (watch.fails_at < 0) return false;
  const bool full = watch.kind == Kind::DiskFull;
  if (full ? n < watch.fails_at || !needs_space : n != watch.fails_at) return false;
  watch.failed = true;
  errno = full ? ENOSPC : EIO;
  return true;
}

long call(long number, long a, long b = 0, long c = 0, long d = 0, long e = 0) {
  return syscall(number, a, b, c, d, e);
}

long pointer(const void* p) { return reinterpret_cast<long>(p); }

}  // namespace

// These come before those of the C library, for the C++ library, too.
extern "C" {

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if (flags & O_CREAT) {
    va_list rest;
    va_start(rest, flags);
    mode = va_arg(rest, mode_t);
    va_end(rest);
  }
  if (fails(flags & O_CREAT)) return -1;
  return static_cast<int>(call(SYS_openat, AT_FDCWD, pointer(path), flags, mode));
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (fails(true)) {
    if (size < 2 || watch.is_half_written) return -1;
    watch.is_half_written = true;
    watch.fails_at = watch.count;  // the write of the rest
    size /= 2;
  }
  return call(SYS_write, descriptor, pointer(bytes), static_cast<long>(size));
}

int fsync(int descriptor) {
  if (fails(true)) return -1;
  return watch.on ? 0 : static_cast<int>(call(SYS_fsync, descriptor));
}

int fdatasync(int descriptor) {
  if (fails(true)) return -1;
  return watch.on ? 0 : static_cast<int>(call(SYS_fdatasync, descriptor));
}

int close(int descriptor) {
  const bool failed = fails(false);
  const int error = errno;
  const auto status = static_cast<int>(call(SYS_close, descriptor));
  if (!failed) return status;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) noexcept {
  if (fails(false)) return -1;
  return static_cast<int>(call(SYS_renameat2, AT_FDCWD, pointer(from), AT_FDCWD, pointer(to)));
}

int link(const char* from, const char* to) noexcept {
  if (fails(true)) return -1;
  return static_cast<int>(call(SYS_linkat, AT_FDCWD, pointer(from), AT_FDCWD, pointer(to)));
}

int ftruncate(int descriptor, off_t size) noexcept {
  if (fails(false)) return -1;
  return static_cast<int>(call(SYS_ftruncate, descriptor, size));
}

}  // extern "C"

namespace trivet::test {

FileFault::FileFault(Kind kind, std::int64_t n) { watch = {true, false, false, kind, 0, n}; }
FileFault::~FileFault() { watch = {}; }
std::int64_t FileFault::num_calls() const { return watch.count; }
bool FileFault::has_failed() const { return watch.failed; }

}  // namespace trivet::test
