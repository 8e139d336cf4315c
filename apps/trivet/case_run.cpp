#include "apps/trivet/case_run.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>

#include "core/base/error.h"

namespace trivet::apps {
namespace {

// A file without a name, which vanishes with its descriptor.
class Stream {
 public:
  Stream() {
    std::string name = (std::filesystem::temp_directory_path() / "trivet-XXXXXX").string();
    m_descriptor = mkostemp(name.data(), O_CLOEXEC);
    if (m_descriptor < 0)
      throw Error(Error::Kind::Environment, "no temporary file: %1", std::strerror(errno));
    unlink(name.c_str());
  }
  ~Stream() { close(m_descriptor); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  int descriptor() const { return m_descriptor; }

  std::string last(size_t most) const {
    const off_t size = lseek(m_descriptor, 0, SEEK_END);
    const off_t start = std::max<off_t>(0, size - static_cast<off_t>(most));
    std::string out(static_cast<size_t>(size - start), '\0');
    const ssize_t got = pread(m_descriptor, out.data(), out.size(), start);
    out.resize(got > 0 ? static_cast<size_t>(got) : 0);
    return out;
  }

 private:
  int m_descriptor = -1;
};

pid_t start(const std::string& program, std::string name, const std::vector<std::string>& arguments,
            const Stream& output, const Stream& error) {
  std::vector<char*> pointers{name.data()};
  for (const std::string& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error.descriptor(), STDERR_FILENO);
  pid_t child = 0;
  const int failure =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0)
    throw Error(Error::Kind::Environment, "%1 does not start: %2", name, std::strerror(failure));
  return child;
}

CaseRun run(const std::string& program, const std::string& name,
            const std::vector<std::string>& arguments, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Stream output, error;
  const pid_t child = start(program, name, arguments, output, error);
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  CaseRun out;
  int state = 0;
  while (waitpid(child, &state, out.out_of_time ? 0 : WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    out.out_of_time = Clock::now() >= end;
    if (out.out_of_time) kill(child, SIGKILL);
  }
  if (WIFEXITED(state)) out.status = WEXITSTATUS(state);
  if (WIFSIGNALED(state)) out.signal = WTERMSIG(state);
  out.output = output.last(CaseRun::kMostBytes);
  out.error = error.last(CaseRun::kMostBytes);
  return out;
}

}  // namespace

CaseRun run_case(const std::vector<std::string>& arguments, double seconds) {
  return run("/proc/self/exe", "trivet", arguments, seconds);
}

CaseRun run_program(const std::string& program, const std::vector<std::string>& arguments,
                    double seconds) {
  return run(program, program, arguments, seconds);
}

}  // namespace trivet::apps
