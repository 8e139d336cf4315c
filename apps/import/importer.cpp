#include "apps/import/importer.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/standard_streams.h"
#include "core/io/sandboxed_import.h"

namespace trivet::apps {
namespace {

constexpr int kOutput = 3;

void limit(int resource, rlim_t value, rlim_t hard_extra = 0) {
  const rlimit both{value, value + hard_extra};
  setrlimit(resource, &both);
}

}  // namespace

void import_and_exit(int argc, char** argv, ModelReader reader) {
  open_standard_streams();
  if (argc != 8) _exit(2);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  ImportLimits limits;
  limits.max_file_bytes = std::strtoull(argv[2], nullptr, 10);
  limits.max_triangles = std::strtoll(argv[3], nullptr, 10);
  limits.max_memory_bytes = std::strtoull(argv[4], nullptr, 10);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::strtod(argv[5], nullptr)), 5);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, limits.max_memory_bytes);  // not under sanitizers, which reserve terabytes
#endif
  const Tessellation tessellation{std::strtod(argv[6], nullptr), std::strtod(argv[7], nullptr)};
  const std::string path = argv[1];
  const auto read = [&] { return reader(path, limits, tessellation); };
  const int status = serve_import(read, path, limits, kOutput);
  _exit(status);  // skips destructors of libraries, which a bad file might crash
}

}  // namespace trivet::apps
