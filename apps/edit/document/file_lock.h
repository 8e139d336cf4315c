// Keeps two editors from one file. The lock goes with the program, however it ends.
#pragma once

#include <memory>
#include <string>

namespace trivet::edit {

class FileLock {
 public:
  /// @param folder  where locks are, made if it is not there. @param file  need not exist.
  /// @throws Error (Environment): another editor has the file open, or the folder cannot be used.
  FileLock(const std::string& folder, const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  const std::string& file() const { return m_file; }

 private:
  std::string m_file;
  int m_descriptor = -1;
};

/// Whether somebody has locked this file with flock(): a journal that is being written.
bool is_locked(const std::string& path);

}  // namespace trivet::edit
