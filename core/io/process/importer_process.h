// Private. The program trivet-import as a process, and what is asked of it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/process/local_sockets.h"
#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

/// @param error  as errno.   @throws Error (Environment)
[[noreturn]] void fail_environment(const Sentence& what, int error);

/// A file to read and its limits; as texts, the program's arguments.
struct ImportRequest {
  std::string path;
  ImportLimits limits;  // without the importer
  Tessellation tessellation;

  std::vector<std::string> texts() const;
  /// nullopt: not as many texts as texts() has.
  static std::optional<ImportRequest> of(const std::vector<std::string>& texts);
};

/// The only argument of an importer that is to tell what confines it.
inline constexpr const char* kAskProtection = "--protection";

/// A running importer; killed and reaped on destruction at the latest.
class ImporterProcess {
 public:
  /// @param arguments  those of a request: it answers on `descriptor`; none: it takes requests
  ///   from there, a socket.
  /// @throws Error (Environment)
  ImporterProcess(const std::string& program, const std::vector<std::string>& arguments,
                  int descriptor);
  ~ImporterProcess();
  ImporterProcess(const ImporterProcess&) = delete;
  ImporterProcess& operator=(const ImporterProcess&) = delete;
  /// Until it ends. @return its status, as of waitpid().
  int wait();

 private:
  pid_t m_id = -1;
};

/// One importer for file after file: each is read by a process of its own, forked from it, as
/// starting the program takes longer than reading a small model. Not thread-safe.
class ImporterServer {
 public:
  /// @throws Error (Environment)
  explicit ImporterServer(const std::string& program);
  const std::string& program() const { return m_program; }
  /// Begins to read; the answer comes on `output`.
  void ask(const ImportRequest& request, int output);
  /// After the answer's end: the status of the process that read, or of the importer.
  int status();

 private:
  std::string m_program;
  Descriptor m_socket;
  std::optional<ImporterProcess> m_process;
};

/// The importer's side of ImporterServer::ask(): what to read, and the descriptor for the answer.
/// @return nullopt: no more requests.
std::optional<std::pair<ImportRequest, Descriptor>> next_request(int socket);
/// Waits until the process `reader` ends, which holds the other end of the pipe `alive` and nobody
/// else does, and says how; kills it if the one who asked is gone.
/// @return whether the answer could be sent.
bool send_status(int socket, pid_t reader, int alive);

}  // namespace trivet
