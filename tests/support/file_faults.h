// Counts file operations of this test program, and lets one of them fail.
#pragma once

#include <cstdint>

namespace trivet::test {

/// While it lives, this thread's calls of open, write, fsync, fdatasync, close, rename, link and
/// ftruncate count, and fail as the kind says. Nothing is synced. A write that fails has written
/// half of its bytes.
class FileFault {
 public:
  enum class Kind {
    Once,      // the n-th call (0: the first; negative: never), with EIO
    DiskFull,  // from the n-th call on all that needs space, with ENOSPC
  };
  explicit FileFault(Kind kind, std::int64_t n = -1);
  ~FileFault();
  FileFault(const FileFault&) = delete;
  FileFault& operator=(const FileFault&) = delete;

  std::int64_t num_calls() const;
  bool has_failed() const;
};

}  // namespace trivet::test
