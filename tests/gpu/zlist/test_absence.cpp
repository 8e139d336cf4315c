// The stage on machines with missing features. The file is the first of this program: once EGL has
// loaded its drivers, a forked process has them too.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "support/check_stage.h"

namespace trivet {
namespace {

constexpr unsigned kAbsenceSeed = 4711;
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

/// Status of a child whose driver has no later OpenGL, with this method: 0 if it gives the answers
/// of brute force.
int status_with_version(const char* version, GpuMethod method, const char* description) {
  return exit_status_with("MESA_GL_VERSION_OVERRIDE", version, [&] {
    const auto stage = make_gpu_candidate_finder({.resolution = 64, .method = method});
    if (stage->name().find(description) == std::string::npos) return 10;
    const test::MeshPool pool(kAbsenceSeed, 4);
    const test::StageCheck check = test::check_stage(*stage, pool, kAbsenceSeed, 0, 60);
    return check.failures.empty() && check.num_contacts > 15 && check.num_unusable == 0 ? 0 : 12;
  });
}

TEST(ZListGpuAbsent, WorksWithEveryOpenGL) {
  const auto check = [](const char* version, GpuMethod method, const char* description) {
    const int status = status_with_version(version, method, description);
    if (status == kHasNone) GTEST_SKIP() << "this machine has no OpenGL through EGL";
    if (status == 10) GTEST_SKIP() << "this driver does not obey MESA_GL_VERSION_OVERRIDE";
    EXPECT_EQ(status, 0) << version << " " << description;
  };
  check("3.3", GpuMethod::Auto, "framebuffers, transform feedback, OpenGL 3.3");
  check("4.3", GpuMethod::Framebuffer, "framebuffers, OpenGL 4.3");
  check("4.3", GpuMethod::Compute, "compute shaders, OpenGL 4.3");
  check("4.5", GpuMethod::Framebuffer, "framebuffers, OpenGL 4.5");
}

TEST(ZListGpuAbsent, RefusesComputeShadersOfOldOpenGL) {
  const int status = exit_status_with("MESA_GL_VERSION_OVERRIDE", "3.3", [] {
    try {
      make_gpu_candidate_finder({.method = GpuMethod::Compute});
      return 10;
    } catch (const Error& error) {
      const std::string why = error.what();
      if (why.find("need OpenGL 4.3, here is 3.3") != std::string::npos) return 0;
      throw;
    }
  });
  if (status == kHasNone) GTEST_SKIP() << "this machine has no OpenGL through EGL";
  if (status == 10) GTEST_SKIP() << "this driver does not obey MESA_GL_VERSION_OVERRIDE";
  EXPECT_EQ(status, 0);
}

/// Each has a context of its own; they wait for each other at most.
TEST(ZListGpuAbsent, ServesTwoProcessesOnOneRenderer) {
  std::array<pid_t, 2> children{};
  for (pid_t& child : children) {
    child = fork();
    if (child != 0) continue;
    const unsigned seed = kAbsenceSeed + (&child == children.data() ? 0 : 1);
    _exit(exit_status_with("TRIVET_NOTHING", "", [&] {
      const auto stage = make_gpu_candidate_finder({.method = GpuMethod::Framebuffer});
      const test::MeshPool pool(seed, 4);
      const test::StageCheck check = test::check_stage(*stage, pool, seed, 0, 60);
      return check.failures.empty() && check.num_contacts > 15 && check.num_unusable == 0 ? 0 : 12;
    }));
  }
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kHasNone) GTEST_SKIP() << "this machine has no OpenGL through EGL";
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
}

}  // namespace
}  // namespace trivet
