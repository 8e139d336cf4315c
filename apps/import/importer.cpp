#include "apps/import/importer.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <string>
#include <vector>

#include "apps/import/confinement.h"
#include "core/io/process/importer_process.h"
#include "core/io/process/sandboxed_import.h"
#include "core/io/process/standard_streams.h"

namespace trivet::apps {
namespace {

constexpr int kParent = 3;  // where answers go, or requests come from

void limit(int resource, rlim_t value, rlim_t hard_extra = 0) {
  const rlimit both{value, value + hard_extra};
  setrlimit(resource, &both);
}

// Exits without destructors of libraries, which a bad file might crash.
[[noreturn]] void read_and_exit(const ImportRequest& request, ModelReader reader, int output,
                                const Protection& process) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(request.limits.max_seconds) + 1), 5);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, request.limits.max_memory_bytes);  // sanitizers reserve terabytes
#endif
  if (!answer_protection(confine_reading(request.path, process), output)) _exit(1);
  const auto read = [&] { return reader(request.path, request.limits, request.tessellation); };
  _exit(serve_import(read, request.path, request.limits, output));
}

// A process for each request; the next is taken when it has ended.
[[noreturn]] void serve_and_exit(ModelReader reader, const Protection& process) {
  fcntl(kParent, F_SETFD, FD_CLOEXEC);
  signal(SIGCHLD, SIG_DFL);  // or children that nobody waits for, as the parent wished for its own
  const pid_t self = getpid();
  while (true) {
    auto next = next_request(kParent);
    int ends[2];
    if (!next || pipe2(ends, O_CLOEXEC) != 0) _exit(0);
    const Descriptor alive(ends[0]);
    Descriptor held(ends[1]);
    const pid_t child = fork();
    if (child < 0) _exit(1);
    if (child == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != self) _exit(1);
      close(kParent);
      read_and_exit(next->first, reader, next->second.number(), process);
    }
    next.reset();
    held.reset();
    if (!send_status(kParent, child, alive.number())) _exit(0);
  }
}

}  // namespace

void import_and_exit(int argc, char** argv, ModelReader reader) {
  open_standard_streams();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const Protection process = confine_process(kParent);
  if (argc == 1) serve_and_exit(reader, process);
  if (argc == 2 && std::string(argv[1]) == kAskProtection)
    _exit(answer_protection(confine_reading("/", process), kParent) ? 0 : 1);
  const auto request = ImportRequest::of({argv + 1, argv + argc});
  if (!request) _exit(2);
  read_and_exit(*request, reader, kParent, process);
}

}  // namespace trivet::apps
