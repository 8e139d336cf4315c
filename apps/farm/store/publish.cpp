#include "apps/farm/store/publish.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace trivet::farm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTemporaryMark = ".trivet-tmp.";

[[noreturn]] void fail(const std::string& path, int error) {
  throw Error(Error::Kind::Environment, "%1: cannot be written: %2", path, std::strerror(error));
}

std::string folder_of_file(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// A name that is in the folder is on the disk only when the folder is.
void sync_folder(const std::string& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail(folder, errno);
  const int result = fsync(descriptor);
  const int error = errno;
  close(descriptor);
  if (result != 0 && error != EINVAL && error != EBADF) fail(folder, error);
}

// @param shown  its name in messages.
int created(const std::string& path, const std::string& shown) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(shown, errno);
  return descriptor;
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, errno);
    bytes.remove_prefix(static_cast<size_t>(count));
  }
}

void sync_and_close(int descriptor, const std::string& path) {
  const int synced = fsync(descriptor);
  const int error = errno;
  const int closed = close(descriptor);
  if (synced != 0) fail(path, error);
  if (closed != 0) fail(path, errno);
}

// Where there are no locks age alone tells what was left behind.
// @param kind  NFS grants LOCK_EX for what is open for writing, LOCK_SH for the rest.
void lock_temporary(int descriptor, int kind) { flock(descriptor, kind | LOCK_NB); }

// EXDEV: some file systems give it for names of one folder, too, such as those with quotas of
// projects.
bool has_no_links(int error) {
  return error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK ||
         error == EXDEV;
}

/// rename(2) that replaces nothing. @return false where the name is taken.
bool renamed(const std::string& from, const std::string& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return false;
  if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) fail(to, errno);
  // The last resort, where the kernel or the file system has neither: of two that come between
  // these two lines the later one stays. Units of a batch are the same bytes; two batches that
  // begin in one folder at the same moment would not be told apart.
  if (access(to.c_str(), F_OK) == 0) return false;
  if (rename(from.c_str(), to.c_str()) != 0) fail(to, errno);
  return true;
}

// NFS may lose the answer of a link that was made: the number of names tells.
bool has_two_names(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && status.st_nlink == 2;
}

}  // namespace

std::string temporary_name(const std::string& path) {
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  // Containers may have one host name and process number in common.
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number))
    fail(path, errno);
  const fs::path file(path);
  const std::string name = "." + file.filename().string() + kTemporaryMark + host + "." +
                           std::to_string(getpid()) + "." + std::to_string(number);
  return (file.parent_path() / name).string();
}

bool is_temporary(const std::string& file_name) {
  return !file_name.empty() && file_name[0] == '.' &&
         file_name.find(kTemporaryMark) != std::string::npos;
}

void make_folders(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, error.value());
}

bool is_being_written(const std::string& temporary) {
  Descriptor file(open(temporary.c_str(), O_WRONLY | O_CLOEXEC));  // a folder cannot be
  if (file.number() < 0) file = Descriptor(open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  return file.number() >= 0 && flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

fs::file_time_type time_in(const std::string& folder) {
  const std::string path = temporary_name((fs::path(folder) / "time").string());
  const Descriptor file(created(path, folder));
  std::error_code error;
  const fs::file_time_type now = fs::last_write_time(path, error);
  unlink(path.c_str());
  if (error) fail(folder, error.value());
  return now;
}

PublishedFile::PublishedFile(const std::string& path)
    : m_path(path), m_temporary(temporary_name(path)) {
  make_folders(folder_of_file(path));
  m_descriptor = Descriptor(created(m_temporary, m_path));
  lock_temporary(m_descriptor.number(), LOCK_EX);
}

PublishedFile::~PublishedFile() {
  m_descriptor.reset();
  unlink(m_temporary.c_str());
}

void PublishedFile::write(std::string_view bytes) {
  write_all(m_descriptor.number(), bytes, m_path);
}

bool PublishedFile::publish() {
  if (fsync(m_descriptor.number()) != 0) fail(m_path, errno);
  bool first = link(m_temporary.c_str(), m_path.c_str()) == 0;
  if (!first) {
    const int error = errno;
    if (has_two_names(m_temporary))
      first = true;
    else if (has_no_links(error))
      first = renamed(m_temporary, m_path);
    else if (error != EEXIST)
      fail(m_path, error);
  }
  if (first) sync_folder(folder_of_file(m_path));
  return first;
}

PublishedFolder::PublishedFolder(const std::string& path)
    : m_path(path), m_temporary(temporary_name(path)) {
  make_folders(m_temporary);
  m_descriptor = Descriptor(open(m_temporary.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (m_descriptor.number() < 0) fail(m_temporary, errno);
  lock_temporary(m_descriptor.number(), LOCK_SH);
}

PublishedFolder::~PublishedFolder() {
  std::error_code ignored;
  fs::remove_all(m_temporary, ignored);
}

std::string PublishedFolder::prepared(const std::string& name) {
  std::string path = (fs::path(m_temporary) / name).string();
  make_folders(folder_of_file(path));
  return path;
}

void PublishedFolder::add(const std::string& name, std::string_view bytes) {
  const std::string path = prepared(name);
  const int descriptor = created(path, path);
  try {
    write_all(descriptor, bytes, path);
  } catch (...) {
    close(descriptor);
    throw;
  }
  sync_and_close(descriptor, path);
}

void PublishedFolder::add_copy(const std::string& name, const std::string& from) {
  const std::string path = prepared(name);
  std::error_code error;
  fs::copy_file(from, path, fs::copy_options::overwrite_existing, error);
  if (error) fail(path, error.value());
  fs::permissions(path,
                  fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read |
                      fs::perms::others_read,
                  error);
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, errno);
  sync_and_close(descriptor, path);
}

bool PublishedFolder::publish() {
  for (const auto& entry : fs::recursive_directory_iterator(m_temporary))
    if (entry.is_directory()) sync_folder(entry.path().string());
  sync_folder(m_temporary);
  if (rename(m_temporary.c_str(), m_path.c_str()) == 0) {
    sync_folder(folder_of_file(m_path));
    return true;
  }
  if (errno != ENOTEMPTY && errno != EEXIST) fail(m_path, errno);
  return false;
}

}  // namespace trivet::farm
