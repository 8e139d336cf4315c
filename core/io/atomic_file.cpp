#include "core/io/atomic_file.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "core/base/error.h"
#include "core/io/opened_files.h"
#include "core/io/overwrites.h"
#include "core/io/staged_files.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const std::string& path, int error) {
  throw Error(Error::Kind::Environment, "%1: cannot be written: %2", path, std::strerror(error));
}

}  // namespace

/// An open file that is deleted unless kept. Named in the library's namespace: StagedFiles::File,
/// which a header declares, has one.
class HiddenFile {
 public:
  /// Hidden, beside the target: a rename is atomic only within one file system.
  explicit HiddenFile(const fs::path& target) {
    std::string stem(1, '.');
    stem += target.filename().string().substr(0, 200) + ".";
    for (int i = 0; m_descriptor < 0; ++i) {
      m_path = target.parent_path() / (stem + std::to_string(getpid()) + "_" + std::to_string(i));
      // 0666 less the umask, as for any new file; mkstemp would make it private.
      m_descriptor = open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (m_descriptor < 0 && errno != EEXIST) fail_to_write(target.string(), errno);
    }
  }
  ~HiddenFile() {
    if (m_descriptor >= 0) close(m_descriptor);
    if (!m_kept) unlink(m_path.c_str());
  }
  HiddenFile(const HiddenFile&) = delete;
  HiddenFile& operator=(const HiddenFile&) = delete;

  int descriptor() const { return m_descriptor; }
  const fs::path& path() const { return m_path; }

  void sync_and_close(const fs::path& target) {
    if (fsync(m_descriptor) != 0) fail_to_write(target.string(), errno);
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (close(descriptor) != 0) fail_to_write(target.string(), errno);
  }

  void rename_to(const fs::path& target) {
    if (std::rename(m_path.c_str(), target.c_str()) != 0) fail_to_write(target.string(), errno);
    m_kept = true;
  }

 private:
  fs::path m_path;
  int m_descriptor = -1;
  bool m_kept = false;
};

namespace {

void write_all(int descriptor, const std::string& bytes, const std::string& path) {
  const char* next = bytes.data();
  const char* const end = next + bytes.size();
  while (next < end) {
    const ssize_t written = ::write(descriptor, next, static_cast<size_t>(end - next));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to_write(path, errno);
    next += written;
  }
}

/// A file that is open for reading.
class SourceFile {
 public:
  explicit SourceFile(const std::string& path)
      : m_path(path), m_descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (m_descriptor < 0) fail_to_read(errno);
  }
  ~SourceFile() { close(m_descriptor); }
  SourceFile(const SourceFile&) = delete;
  SourceFile& operator=(const SourceFile&) = delete;

  /// True if the other, empty file has the same bytes now, without a copy: a write to either parts
  /// them. False where the file system has no such copies.
  bool share_with(int descriptor) const { return ioctl(descriptor, FICLONE, m_descriptor) == 0; }

  void pass_on(const ByteSink& write) const {
    std::string block;
    for (block.resize(1 << 16); const size_t count = read_into(block); block.resize(1 << 16)) {
      block.resize(count);
      write(block);
    }
  }

 private:
  size_t read_into(std::string& block) const {
    while (true) {
      const ssize_t count = ::read(m_descriptor, block.data(), block.size());
      if (count >= 0) return static_cast<size_t>(count);
      if (errno != EINTR) fail_to_read(errno);
    }
  }
  [[noreturn]] void fail_to_read(int error) const {
    throw Error(Error::Kind::Environment, "%1: cannot be read: %2", m_path, std::strerror(error));
  }

  std::string m_path;
  int m_descriptor;
};

// Makes the rename durable; file systems that cannot do so break no guarantee.
void sync_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

// Devices and pipes cannot be replaced: /dev/stdout, /dev/null, a FIFO.
void write_through(const std::string& path, const FileContent& content) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail_to_write(path, errno);
  try {
    content([&](const std::string& bytes) { write_all(descriptor, bytes, path); });
  } catch (...) {
    close(descriptor);
    throw;
  }
  if (close(descriptor) != 0) fail_to_write(path, errno);
}

}  // namespace

void write_file_atomically(const std::string& path, const std::string& bytes) {
  write_file_atomically(path, [&](const ByteSink& write) { write(bytes); });
}

/// One file on its way; devices and pipes, which cannot be replaced, are written at the end.
struct StagedFiles::File {
  std::string path;
  std::string late_bytes;  // of a device or pipe
  fs::path target;
  std::unique_ptr<HiddenFile> temporary;
  bool replaces = false, is_committed = false;
  std::string old;  // second name of what was there; empty: none

  /// @param source  may be null; a file whose bytes `content` passes on, too.
  File(const std::string& file, const FileContent& content, const SourceFile* source = nullptr)
      : path(file) {
    struct stat there {};
    const bool exists = replaces = stat(path.c_str(), &there) == 0;
    if (exists && S_ISDIR(there.st_mode)) fail_to_write(path, EISDIR);
    if (exists && !S_ISREG(there.st_mode)) {
      content([&](const std::string& bytes) { late_bytes += bytes; });
      return;
    }
    if (exists && faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
      fail_to_write(path, errno);
    // Follows a symbolic link, so that the link itself stays.
    std::error_code error;
    target = exists ? fs::canonical(path, error) : fs::absolute(path, error);
    if (error) fail_to_write(path, error.value());
    temporary = std::make_unique<HiddenFile>(target);
    if (!source || !source->share_with(temporary->descriptor()))
      content([&](const std::string& bytes) { write_all(temporary->descriptor(), bytes, path); });
    if (exists) fchmod(temporary->descriptor(), there.st_mode & 07777);
    temporary->sync_and_close(path);
  }

  ~File() {
    if (!old.empty()) unlink(old.c_str());
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void commit() {
    if (!temporary)
      return write_through(path, [this](const ByteSink& write) { write(late_bytes); });
    temporary->rename_to(target);
    is_committed = true;
    sync_folder(target.parent_path());
  }

  /// A second name for what is there; file systems without hard links have none.
  void keep_old() {
    if (!temporary || !replaces) return;
    const std::string name = temporary->path().string() + ".old";
    if (link(target.c_str(), name.c_str()) == 0) old = name;
  }
  void take_back() noexcept {
    if (!is_committed) return;
    if (!old.empty() && std::rename(old.c_str(), target.c_str()) == 0) old.clear();
    if (!replaces) unlink(target.c_str());
  }
};

StagedFiles::StagedFiles(std::string owner) : m_owner(std::move(owner)) {}

StagedFiles::~StagedFiles() {
  m_files.clear();
  std::error_code ignored;  // fs::remove() leaves folders alone that hold something
  for (auto folder = m_folders.rbegin(); folder != m_folders.rend(); ++folder)
    fs::remove(*folder, ignored);
}

void StagedFiles::add_folder(const std::string& path) {
  std::vector<std::string> made;
  std::error_code error;
  for (fs::path folder = path; !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path())
    made.insert(made.begin(), folder.string());
  m_folders.insert(m_folders.end(), made.begin(), made.end());
  fs::create_directories(path, error);
  if (error)
    throw Error(Error::Kind::Environment, "%1: cannot be made: %2", path, error.message().c_str());
}

void StagedFiles::add(const std::string& path, const std::string& bytes) {
  add(path, [&](const ByteSink& write) { write(bytes); });
}

void StagedFiles::add(const std::string& path, const FileContent& content) {
  check_owner(path);
  add_folder_above(path);
  m_files.push_back(std::make_unique<File>(path, content));
}

void StagedFiles::add_copy(const std::string& path, const std::string& from) {
  check_owner(path);
  const SourceFile source(from);
  add_folder_above(path);
  m_files.push_back(std::make_unique<File>(
      path, [&](const ByteSink& write) { source.pass_on(write); }, &source));
}

void StagedFiles::check_owner(const std::string& path) const {
  if (const std::string model = model_that_opened(path, m_owner); !model.empty())
    fail_as_input(path, model);
}

void StagedFiles::add_folder_above(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  std::error_code ignored;
  if (!folder.empty() && !fs::exists(folder, ignored)) add_folder(folder);
}

void StagedFiles::commit() {
  for (size_t i = 0; i + 1 < m_files.size(); ++i) m_files[i]->keep_old();
  try {
    for (const auto& file : m_files) file->commit();
  } catch (...) {
    for (const auto& file : m_files) file->take_back();
    throw;
  }
  m_files.clear();
  m_folders.clear();
}

void write_file_atomically(const std::string& path, const FileContent& content) {
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))
    return write_through(path, content);  // piece by piece
  StagedFiles staged;
  staged.add(path, content);
  staged.commit();
}

void copy_file_atomically(const std::string& from, const std::string& to) {
  StagedFiles staged;
  staged.add_copy(to, from);
  staged.commit();
}

}  // namespace trivet
