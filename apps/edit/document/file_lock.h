// Lock against opening a file in two editors. Released when the process ends, however it ends.
#pragma once

#include <memory>
#include <string>

namespace trivet::edit {

class FileLock {
 public:
  /// @param folder  of lock files, created if missing. @param file  need not exist.
  /// @throws Error (Environment): another editor has the file open, or the folder is unusable.
  FileLock(const std::string& folder, const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  const std::string& file() const { return m_file; }

 private:
  std::string m_file;
  int m_descriptor = -1;
};

/// True if this file is locked with flock(): a journal being written.
bool is_locked(const std::string& path);

}  // namespace trivet::edit
