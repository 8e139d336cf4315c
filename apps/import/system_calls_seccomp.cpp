#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <memory>

#include "apps/import/system_calls.h"

namespace trivet::apps {
namespace {

// Harmless whatever their arguments. Names that an architecture lacks are left out there.
constexpr const char* kAllowed[] = {
    // Descriptors that are open already.
    "read", "pread64", "readv", "write", "writev", "lseek", "_llseek", "close", "fstat", "fstat64",
    "getdents64", "fadvise64", "readahead",
    // Names of files.
    "stat", "lstat", "newfstatat", "fstatat64", "statx", "access", "faccessat", "faccessat2",
    "readlink", "readlinkat", "getcwd",
    // Memory, but for mappings of code.
    "brk", "munmap", "mremap", "madvise",
    // Threads and time.
    "futex", "futex_time64", "set_robust_list", "rseq", "sched_yield", "sched_getaffinity",
    "membarrier", "nanosleep", "clock_nanosleep", "clock_gettime", "clock_getres", "gettimeofday",
    "time", "times", "getrusage", "exit", "exit_group", "restart_syscall",
    // Signals to this process, and what it is.
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack", "getpid", "gettid", "getppid",
    "getuid", "geteuid", "getgid", "getegid", "uname", "sysinfo", "getrandom",
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    "pipe", "pipe2",  // sanitizers write what they are not sure to read into one
#endif
};

class Filter {
 public:
  Filter() : m_context(seccomp_init(SCMP_ACT_ERRNO(ENOSYS)), seccomp_release) {
    m_whole = m_context && seccomp_attr_set(m_context.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2) == 0;
  }

  // With arguments like these, all of them.
  void allow(const char* name, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call < 0 || !m_whole) return;
    m_whole =
        seccomp_rule_add_array(m_context.get(), SCMP_ACT_ALLOW, call,
                               static_cast<unsigned>(arguments.size()), arguments.begin()) == 0;
  }
  bool load() { return m_whole && seccomp_load(m_context.get()) == 0; }

 private:
  std::unique_ptr<void, decltype(&seccomp_release)> m_context;
  bool m_whole;
};

scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}
scmp_arg_cmp without(unsigned argument, scmp_datum_t bits) {
  return {argument, SCMP_CMP_MASKED_EQ, bits, 0};
}

}  // namespace

bool filter_system_calls() {
  Filter filter;
  for (const char* const name : kAllowed) filter.allow(name);
  constexpr scmp_datum_t kWrites = O_ACCMODE | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY);
  filter.allow("open", {without(1, kWrites)});
  filter.allow("openat", {without(2, kWrites)});
  for (const char* const name : {"mmap", "mmap2", "mprotect"})
    filter.allow(name, {without(2, PROT_EXEC)});
  filter.allow("clone", {{0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD}});
  for (const int what : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD_CLOEXEC})
    filter.allow("fcntl", {equal(1, static_cast<scmp_datum_t>(what))});
  filter.allow("prlimit64", {equal(0, 0), equal(2, 0)});  // to ask for limits
  const auto self = static_cast<scmp_datum_t>(getpid());
  filter.allow("tgkill", {equal(0, self)});  // abort()
  return filter.load();
}

}  // namespace trivet::apps
