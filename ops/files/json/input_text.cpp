#include "ops/files/json/input_text.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

// An object, and no zero byte in the last block of it.
bool may_be_json(const std::string& text) {
  constexpr size_t kBlock = 1 << 16;
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] != '{') return false;
  return text.find('\0', text.size() < kBlock ? 0 : text.size() - kBlock) == std::string::npos;
}

/// A file or pipe that is read from its beginning to its end. A named pipe must be opened for
/// writing soon.
class InputFile {
 public:
  explicit InputFile(const std::string& path)
      : m_path(path), m_descriptor(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (m_descriptor < 0) bad_input("%1: cannot be opened: %2", path, std::strerror(errno));
    struct stat status {};
    struct statfs system {};
    m_awaits_writer = fstat(m_descriptor, &status) == 0 && S_ISFIFO(status.st_mode) &&
                      fstatfs(m_descriptor, &system) == 0 && system.f_type != kUnnamedPipe;
  }
  ~InputFile() { close(m_descriptor); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Number of bytes read; 0 at the end.
  size_t read(std::vector<char>& block) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::seconds(kSecondsForWriter);
    while (true) {
      const ssize_t count = ::read(m_descriptor, block.data(), block.size());
      if (count > 0) m_awaits_writer = false;
      if (count > 0 || (count == 0 && !m_awaits_writer)) return static_cast<size_t>(count);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK)
        bad_input("%1: cannot be read: %2", m_path, std::strerror(errno));
      if (count < 0) m_awaits_writer = false;  // there is one, who has written nothing yet
      if (m_awaits_writer && Clock::now() > deadline)
        bad_input(
            "%1: is a pipe that nobody has opened for writing within %2 s; accepted: a file, or a "
            "pipe that is fed",
            m_path, kSecondsForWriter);
      pollfd waiting{m_descriptor, POLLIN, 0};
      if (m_awaits_writer)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // poll() would not wait
      else
        poll(&waiting, 1, -1);
    }
  }

 private:
  static constexpr int kSecondsForWriter = 10;
  static constexpr long kUnnamedPipe = 0x50495045;  // of pipe() and <(...): its end is its end

  const std::string m_path;
  const int m_descriptor;
  bool m_awaits_writer = false;
};

}  // namespace

std::string read_input_text(const std::string& path, std::uintmax_t max_bytes, TextKind kind) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) bad_input("%1: is a folder, not a file", path);
  InputFile file(path);
  std::string text;
  std::vector<char> block(1 << 16);
  while (const size_t count = file.read(block)) {
    text.append(block.data(), count);
    if (text.size() > max_bytes)
      bad_input("%1: is larger than the limit of %2 bytes", path, max_bytes);
    // Other text may be endless; its beginning is enough for the parser to refuse it.
    if (kind == TextKind::Json && !may_be_json(text)) break;
  }
  return text;
}

}  // namespace trivet
