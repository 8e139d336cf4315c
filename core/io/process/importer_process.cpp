#include "core/io/process/importer_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string_view>

#include "core/base/error.h"

extern char** environ;

namespace trivet {
namespace {

constexpr int kAnswers = 3;  // descriptor of trivet-import

std::string all_digits(double value) {
  char text[32];
  return {text, std::to_chars(std::begin(text), std::end(text), value).ptr};
}

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

int status_of(pid_t id) {
  int status = 0;
  while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

void fail_environment(const Sentence& what, int error) {
  throw Error(Error::Kind::Environment, "%1: %2", what, std::strerror(error));
}

std::vector<std::string> ImportRequest::texts() const {
  return {path,
          std::to_string(limits.max_file_bytes),
          std::to_string(limits.max_triangles),
          std::to_string(limits.max_memory_bytes),
          all_digits(limits.max_seconds),
          all_digits(tessellation.chord),
          all_digits(tessellation.facet_angle_deg)};
}

std::optional<ImportRequest> ImportRequest::of(const std::vector<std::string>& texts) {
  if (texts.size() != 7) return std::nullopt;
  ImportRequest out;
  out.path = texts[0];
  out.limits.max_file_bytes = std::strtoull(texts[1].c_str(), nullptr, 10);
  out.limits.max_triangles = std::strtoll(texts[2].c_str(), nullptr, 10);
  out.limits.max_memory_bytes = std::strtoull(texts[3].c_str(), nullptr, 10);
  out.limits.max_seconds = std::strtod(texts[4].c_str(), nullptr);
  out.tessellation = {std::strtod(texts[5].c_str(), nullptr),
                      std::strtod(texts[6].c_str(), nullptr)};
  return out;
}

ImporterProcess::ImporterProcess(const std::string& program,
                                 const std::vector<std::string>& arguments, int descriptor) {
  std::vector<std::string> texts = {program};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, descriptor, kAnswers);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  ImporterEnvironment environment;
  const int error = posix_spawn(&m_id, program.c_str(), &actions, nullptr, pointers.data(),
                                environment.variables());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail_environment(say("%1: cannot be started", program), error);
}

ImporterProcess::~ImporterProcess() {
  if (m_id <= 0) return;
  kill(m_id, SIGKILL);
  wait();
}

int ImporterProcess::wait() {
  const int status = status_of(m_id);
  m_id = -1;
  return status;
}

ImporterServer::ImporterServer(const std::string& program) : m_program(program) {
  SocketPair ends = socket_pair(SOCK_SEQPACKET);
  m_socket = std::move(ends.a);
  m_process.emplace(program, std::vector<std::string>{}, ends.b.number());
}

// One that is gone is noticed when its answer ends at once.
void ImporterServer::ask(const ImportRequest& request, int output) {
  std::string text;
  for (const std::string& part : request.texts()) text += part + '\0';
  send_message(m_socket.number(), text, output);
}

int ImporterServer::status() {
  const auto answer = receive_message(m_socket.number());
  int out = 0;
  if (!answer || answer->bytes.size() != sizeof out) return m_process->wait();
  std::memcpy(&out, answer->bytes.data(), sizeof out);
  return out;
}

std::optional<std::pair<ImportRequest, Descriptor>> next_request(int socket) {
  auto message = receive_message(socket);
  if (!message) return std::nullopt;
  std::vector<std::string> texts;
  for (std::string_view rest = message->bytes; !rest.empty();) {
    const size_t end = std::min(rest.find('\0'), rest.size() - 1);
    texts.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  auto request = ImportRequest::of(texts);
  if (!request) return std::nullopt;
  return std::pair(*std::move(request), std::move(message->descriptor));
}

bool send_status(int socket, pid_t reader, int alive) {
  pollfd waiting[] = {{socket, 0, 0}, {alive, 0, 0}};  // for their other ends to be closed
  while (poll(waiting, std::size(waiting), -1) < 0 && errno == EINTR) {
  }
  if (!waiting[1].revents) kill(reader, SIGKILL);
  const int status = status_of(reader);
  return !waiting[0].revents && send(socket, &status, sizeof status, MSG_NOSIGNAL) == sizeof status;
}

}  // namespace trivet
