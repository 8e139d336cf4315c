#include "apps/edit/document/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace trivet::edit {

namespace fs = std::filesystem;

FileLock::FileLock(const std::string& folder, const std::string& file) : m_file(file) {
  std::error_code error;
  fs::create_directories(folder, error);
  fs::path whole = fs::weakly_canonical(fs::absolute(file), error);
  if (error) whole = fs::absolute(file).lexically_normal();
  const fs::path lock = fs::path(folder) / (Hash().add(whole.string()).text() + ".lock");
  m_descriptor = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (m_descriptor < 0)
    throw Error(Error::Kind::Environment, "%1: cannot be created: %2", lock.string(),
                std::strerror(errno));
  if (flock(m_descriptor, LOCK_EX | LOCK_NB) == 0) return;
  close(m_descriptor);
  throw Error(Error::Kind::Environment, "%1: is open in another editor; close it there first",
              file);
}

FileLock::~FileLock() { close(m_descriptor); }

bool is_locked(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return locked;
}

}  // namespace trivet::edit
