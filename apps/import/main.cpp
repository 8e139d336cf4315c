// trivet-import: reads one model and sends it to the process that started it (core/io/isolated.h).
//   trivet-import PATH MAX_FILE_BYTES MAX_TRIANGLES MAX_MEMORY_BYTES CPU_SECONDS, answers on 3
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "core/io/isolated.h"

namespace {

void limit(int resource, rlim_t value, rlim_t hard_extra = 0) {
  const rlimit both{value, value + hard_extra};
  setrlimit(resource, &both);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  trivet::ImportLimits limits;
  limits.max_file_bytes = std::strtoull(argv[2], nullptr, 10);
  limits.max_triangles = std::strtoll(argv[3], nullptr, 10);
  limits.max_memory_bytes = std::strtoull(argv[4], nullptr, 10);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::strtod(argv[5], nullptr)), 5);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, limits.max_memory_bytes);  // sanitizers map terabytes and touch little
#endif
  const int status = trivet::serve_import(argv[1], limits, 3);
  _exit(status);  // nothing to clean up, and libraries' destructors may be where a bad file strikes
}
