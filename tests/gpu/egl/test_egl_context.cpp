// The window-less OpenGL context: created, named, shared between threads in turn, or refused
// clearly.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "gpu/egl/context.h"

namespace trivet {
namespace {

std::optional<EglContext> make_context() {
  try {
    return EglContext();
  } catch (const Error&) {
    return std::nullopt;
  }
}

#define TRIVET_SKIP_WITHOUT_EGL(context) \
  if (!(context)) GTEST_SKIP() << "this machine has no OpenGL through EGL"

/// Runs `body` in a child process whose EGL finds no driver; returns its exit status.
template <typename Body>
int exit_status_without_drivers(const Body& body) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// The first test of this file: once EGL has loaded its drivers, a forked process has them too.
TEST(EglContextAbsent, ReportsTriedPlatforms) {
  const int status = exit_status_without_drivers([] {
    try {
      EglContext context;
      return 10;  // drivers were loaded before, or this EGL ignores the variable
    } catch (const Error& error) {
      const std::string message = error.what();
      if (error.kind() != Error::Kind::Environment) return 11;
      return message.find("EGL") != std::string::npos &&
                     message.find("surfaceless") != std::string::npos
                 ? 0
                 : 12;
    } catch (...) {
      return 13;
    }
  });
  if (status == 10) GTEST_SKIP() << "the drivers cannot be hidden here";
  EXPECT_EQ(status, 0);
}

TEST(EglContext, TakesDeviceOfNumber) {
  const std::optional<EglContext> any = make_context();
  TRIVET_SKIP_WITHOUT_EGL(any);
  EglOptions options;
  if (any->device().rfind("EGL device ", 0) == 0) {
    options.device = std::stoi(any->device().substr(11));
    EXPECT_EQ(EglContext(options).device(), any->device());
  }
  options.device = 99;
  try {
    const EglContext context(options);
    ADD_FAILURE() << "there is a device 99";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Environment);
    EXPECT_NE(std::string(error.what()).find("EGL device 99"), std::string::npos) << error.what();
  }
}

TEST(EglContext, ReadsDeviceFromEnvironment) {
  unsetenv("TRIVET_EGL_DEVICE");
  EXPECT_EQ(EglOptions().device, 0);
  setenv("TRIVET_EGL_DEVICE", "3", 1);
  EXPECT_EQ(EglOptions().device, 3);
  for (const char* const bad : {"0", "-1", "two", "1x", "99999999999"}) {
    setenv("TRIVET_EGL_DEVICE", bad, 1);
    EXPECT_THROW(egl_device_from_environment(), Error) << bad;
  }
  unsetenv("TRIVET_EGL_DEVICE");
}

TEST(EglContext, DescribesItself) {
  const std::optional<EglContext> context = make_context();
  TRIVET_SKIP_WITHOUT_EGL(context);
  EXPECT_FALSE(context->renderer().empty());
  EXPECT_FALSE(context->version().empty());
  EXPECT_GE(context->gl_version(), 33);
  EXPECT_NE(context->description().find(context->renderer()), std::string::npos);
  if (context->renderer().find("llvmpipe") != std::string::npos) {
    EXPECT_TRUE(context->is_software());
    EXPECT_NE(context->description().find("(software)"), std::string::npos);
  }
}

TEST(EglContext, MovesAndOutlivesAnotherOnSameDisplay) {
  std::optional<EglContext> first = make_context();
  TRIVET_SKIP_WITHOUT_EGL(first);
  EglContext second;
  first.reset();  // must not terminate the second one's display
  const EglContext third = std::move(second);
  EXPECT_NO_THROW(EglContext::Current{third});
}

TEST(EglContext, BelongsToOneThreadAtATime) {
  const std::optional<EglContext> context = make_context();
  TRIVET_SKIP_WITHOUT_EGL(context);
  bool refused = false, accepted_later = false;
  const auto try_it = [&] {
    try {
      const EglContext::Current current(*context);
      return true;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Environment);
      return false;
    }
  };
  {
    const EglContext::Current current(*context);
    std::thread([&] { refused = !try_it(); }).join();
  }
  std::thread([&] { accepted_later = try_it(); }).join();
  EXPECT_TRUE(refused);
  EXPECT_TRUE(accepted_later);
}

TEST(EglContext, NestsGuards) {
  const std::optional<EglContext> outer = make_context();
  TRIVET_SKIP_WITHOUT_EGL(outer);
  const EglContext inner;
  const EglContext::Current current(*outer);
  EXPECT_NO_THROW({
    const EglContext::Current nested(inner);
    const EglContext::Current again(*outer);
  });
}

TEST(EglContext, RefusesSoftwareOnRequest) {
  const std::optional<EglContext> context = make_context();
  TRIVET_SKIP_WITHOUT_EGL(context);
  if (!context->is_software()) GTEST_SKIP() << "this machine has a hardware renderer";
  try {
    EglContext hardware({.allow_software = false});
    FAIL() << "got " << hardware.description();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Environment);
    EXPECT_NE(std::string(error.what()).find("software"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace trivet
