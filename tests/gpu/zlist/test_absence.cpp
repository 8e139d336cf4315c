// The stage on machines with missing features. The file is the first of this program: once EGL has
// loaded its drivers, a forked process has them too.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "gpu/zlist/zlist_gpu.h"
#include "support/check_stage.h"

namespace trivet {
namespace {

constexpr unsigned kSeed = 4711;
constexpr int kHasNone = 20, kUnexpected = 21;

/// Runs `body` in a child process with an environment variable set; returns its exit status.
template <typename Body>
int exit_status_with(const char* variable, const char* value, const Body& body) {
  const pid_t child = fork();
  if (child == 0) {
    setenv(variable, value, 1);
    try {
      _exit(body());
    } catch (const Error& error) {
      _exit(error.kind() == Error::Kind::Environment ? kHasNone : kUnexpected);
    } catch (...) {
      _exit(kUnexpected);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(ZListGpuAbsent, ReportsMissingEgl) {
  const int status = exit_status_with("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", [] {
    try {
      make_gpu_candidate_finder();
      return 10;
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::Environment) return 11;
      return std::string(error.what()).find("EGL") != std::string::npos ? 0 : 12;
    }
  });
  if (status == 10) GTEST_SKIP() << "the drivers cannot be hidden here";
  EXPECT_EQ(status, 0);
}

TEST(ZListGpuAbsent, WorksWithoutCompute) {
  const int status = exit_status_with("MESA_GL_VERSION_OVERRIDE", "3.3", [] {
    const auto stage = make_gpu_candidate_finder({.resolution = 64});
    if (stage->name().find("blended framebuffers") == std::string::npos) return 10;
    const test::MeshPool pool(kSeed, 4);
    const test::StageCheck check = test::check_stage(*stage, pool, kSeed, 0, 60);
    return check.failures.empty() && check.num_contacts > 15 && check.num_unusable == 0 ? 0 : 12;
  });
  if (status == kHasNone) GTEST_SKIP() << "this machine has no OpenGL through EGL";
  if (status == 10) GTEST_SKIP() << "this driver does not obey MESA_GL_VERSION_OVERRIDE";
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace trivet
