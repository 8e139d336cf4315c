#include "core/io/sandboxed_import.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <new>

#include "core/base/bad_input.h"
#include "core/io/model_bytes.h"
#include "core/io/preflight.h"

extern char** environ;

namespace trivet {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kBaseSeconds = 60, kSecondsPerByte = 1e-6;
constexpr std::uintmax_t kBaseMemory = std::uintmax_t{1} << 30, kMemoryPerByte = 64;
constexpr int kOutput = 3;  // descriptor on which trivet-import answers
constexpr int kPipeBytes = 1 << 20;
constexpr double kCancelSeconds = 0.05;  // until it is noticed

[[noreturn]] void fail_environment(const std::string& what, int error) {
  throw Error(Error::Kind::Environment, what + ": " + std::strerror(error));
}

ImportLimits with_defaults(ImportLimits limits, const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  const std::uintmax_t size = error ? 0 : bytes;
  if (!(limits.max_seconds > 0))
    limits.max_seconds = kBaseSeconds + kSecondsPerByte * static_cast<double>(size);
  if (limits.max_memory_bytes == 0) limits.max_memory_bytes = kBaseMemory + kMemoryPerByte * size;
  return limits;
}

std::string all_digits(double value) {
  char text[32];
  return {text, std::to_chars(std::begin(text), std::end(text), value).ptr};
}

/// Importer program for this file. @throws Error (Environment) if its format has none.
std::string importer_of(const std::string& path, const ImportLimits& limits) {
  const std::string format = cad_format(path);
  if (format.empty()) return limits.importer;
  std::string importer = limits.importer + "-cad";
  if (access(importer.c_str(), X_OK) == 0) return importer;
  throw Error(
      Error::Kind::Environment,
      path + ": " + format + " files need " + importer +
          ", which is missing: this build of Trivet lacks Open CASCADE; accepted: a "
          "build with it (Debian: libocct-data-exchange-dev libocct-ocaf-dev; TRIVET_OCCT)");
}

/// A descriptor, closed on destruction.
class Descriptor {
 public:
  explicit Descriptor(int number) : m_number(number) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return m_number; }
  void reset() {
    if (m_number >= 0) close(m_number);
    m_number = -1;
  }

 private:
  int m_number;
};

/// Environment of the importer: glibc maps its memory in huge pages, as assimp clears 16 MiB for
/// each .obj file, and most of the time of reading a small model were page faults.
class ImporterEnvironment {
 public:
  ImporterEnvironment() {
    for (char** at = environ; *at; ++at) m_variables.push_back(*at);
    if (!std::getenv("GLIBC_TUNABLES")) m_variables.push_back(m_tunables.data());
    m_variables.push_back(nullptr);
  }
  char** variables() { return m_variables.data(); }

 private:
  // Freed memory is kept for the next allocation, too.
  std::string m_tunables =
      "GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=33554432:"
      "glibc.malloc.trim_threshold=1073741824";
  std::vector<char*> m_variables;
};

/// A running trivet-import; killed and reaped on destruction at the latest.
class Child {
 public:
  Child(const std::string& importer, const std::string& path, const ImportLimits& limits,
        const Tessellation& tessellation, int output) {
    std::string texts[] = {importer,
                           path,
                           std::to_string(limits.max_file_bytes),
                           std::to_string(limits.max_triangles),
                           std::to_string(limits.max_memory_bytes),
                           std::to_string(std::ceil(limits.max_seconds) + 1),
                           all_digits(tessellation.chord),
                           all_digits(tessellation.facet_angle_deg)};
    std::vector<char*> arguments;
    for (std::string& text : texts) arguments.push_back(text.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, kOutput);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    ImporterEnvironment environment;
    const int error = posix_spawn(&m_id, importer.c_str(), &actions, nullptr, arguments.data(),
                                  environment.variables());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) fail_environment(importer + ": cannot be started", error);
  }
  ~Child() {
    if (m_id <= 0) return;
    kill(m_id, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int wait() {
    int status = 0;
    while (waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
    }
    m_id = -1;
    return status;
  }

 private:
  pid_t m_id = -1;
};

/// Reads all output up to the deadline. @throws Error (BadInput) at the deadline, if the output
/// exceeds the limit, and if cancelled.
std::string received(int descriptor, const std::string& path, const ImportLimits& limits,
                     const std::atomic<bool>* cancel) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.max_seconds);
  std::string out;
  std::array<char, 1 << 16> block;
  while (true) {
    if (cancel && *cancel) bad_file(path, "reading it was cancelled");
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    if (left <= 0)
      bad_file(path, "reading it took longer than the limit of " +
                         std::to_string(static_cast<long>(std::ceil(limits.max_seconds))) + " s");
    pollfd waiting{descriptor, POLLIN, 0};
    const double wait = std::min(left, cancel ? kCancelSeconds : 1e3);
    const int ready = poll(&waiting, 1, static_cast<int>(wait * 1e3 + 1));
    if (ready < 0 && errno != EINTR) fail_environment(path + ": cannot be awaited", errno);
    if (ready <= 0) continue;
    const ssize_t count = read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_environment(path + ": cannot be received", errno);
    if (count == 0) return out;
    out.append(block.data(), static_cast<size_t>(count));
    if (out.size() > limits.max_memory_bytes) bad_file(path, "output exceeds the memory limit");
  }
}

void check_end(int status, const std::string& importer, const std::string& path,
               const ImportLimits& limits) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw Error(Error::Kind::Environment, importer + ": cannot be started");
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
    bad_file(path, "reading it took longer than the limit of " +
                       std::to_string(static_cast<long>(std::ceil(limits.max_seconds))) + " s");
  bad_file(path, "cannot be read as a model: the importer ended with " +
                     (signal ? std::string(strsignal(signal))
                             : "status " + std::to_string(WEXITSTATUS(status))) +
                     "; the file is broken, or needs more memory than the limit of " +
                     std::to_string(limits.max_memory_bytes >> 20) + " MiB");
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

}  // namespace

Model read_model_sandboxed(const std::string& path, const ImportLimits& given,
                           const Tessellation& tessellation, const std::atomic<bool>* cancel) {
  check_file(path, given);  // checks that need no other process
  const std::string importer = importer_of(path, given);
  const ImportLimits limits = with_defaults(given, path);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail_environment(path + ": cannot create a pipe", errno);
  fcntl(ends[0], F_SETPIPE_SZ, kPipeBytes);  // or as it is
  const Descriptor input(ends[0]);
  Descriptor output(ends[1]);
  Child child(importer, path, limits, tessellation, output.number());
  output.reset();
  const std::string bytes = received(input.number(), path, limits, cancel);
  check_end(child.wait(), importer, path, limits);
  try {
    Model model = model_from_bytes(bytes, path, limits);
    if (model.polygonised) model.tessellation = tessellation;
    return model;
  } catch (const Error& e) {
    const std::string message = e.what();
    if (message.rfind(path, 0) == 0 || e.kind() != Error::Kind::BadInput) throw;
    bad_file(path, message);
  }
}

Model import_model(const std::string& path, const ImportLimits& limits,
                   const Tessellation& tessellation, const std::atomic<bool>* cancel) {
  return limits.importer.empty() ? read_model(path, limits)
                                 : read_model_sandboxed(path, limits, tessellation, cancel);
}

std::string find_importer() {
  if (const char* named = std::getenv("TRIVET_IMPORTER")) return named;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return "";
  for (const fs::path& folder : {program.parent_path(), program.parent_path().parent_path()})
    if (const fs::path importer = folder / "trivet-import"; access(importer.c_str(), X_OK) == 0)
      return importer.string();
  return "";
}

int serve_import(const std::function<Model()>& read, const std::string& path,
                 const ImportLimits& limits, int descriptor) {
  const auto answer = [&](const std::string& bytes) {
    return write_all(descriptor, bytes) ? 0 : 1;
  };
  try {
    return answer(bytes_of_model(read()));
  } catch (const Error& e) {
    return answer(bytes_of_error(e.kind(), e.what()));
  } catch (const std::bad_alloc&) {
    return answer(bytes_of_error(Error::Kind::BadInput,
                                 path + ": needs more memory than the limit of " +
                                     std::to_string(limits.max_memory_bytes >> 20) + " MiB"));
  }
}

}  // namespace trivet
