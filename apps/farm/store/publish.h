// Files and folders that appear whole or not at all, and never replace one that is there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/process/local_sockets.h"

namespace trivet::farm {

/// A file of another name in the same folder, of temporary_name(), until it is published. Deleted
/// by the destructor unless it was published; kill -9 leaves it behind, see is_temporary(). It is
/// locked (flock) meanwhile, see is_being_written().
class PublishedFile {
 public:
  /// @throws Error (Environment) when it cannot be made. Makes the folder.
  explicit PublishedFile(const std::string& path);
  ~PublishedFile();
  PublishedFile(const PublishedFile&) = delete;
  PublishedFile& operator=(const PublishedFile&) = delete;

  /// @throws Error (Environment), such as on a full disk.
  void write(std::string_view bytes);
  /// fsync, then link(2), which fails where the name is taken: the first one wins. Where the file
  /// system has no hard links: renameat2(2), which does, too.
  /// @return false if another one was there: this one is dropped.
  bool publish();

 private:
  std::string m_path, m_temporary;
  Descriptor m_descriptor;
};

/// The same of a folder with files.
class PublishedFolder {
 public:
  explicit PublishedFolder(const std::string& path);
  ~PublishedFolder();
  PublishedFolder(const PublishedFolder&) = delete;
  PublishedFolder& operator=(const PublishedFolder&) = delete;

  /// @param name  relative, with folders. @throws Error (Environment).
  void add(const std::string& name, std::string_view bytes);
  void add_copy(const std::string& name, const std::string& from);
  bool publish();

 private:
  std::string prepared(const std::string& name);

  std::string m_path, m_temporary;
  Descriptor m_descriptor;  // of the folder, for the lock
};

/// ".NAME.trivet-tmp.HOST.PID.RANDOM" in the same folder: being written, or left by a process that
/// was killed.
std::string temporary_name(const std::string& path);
bool is_temporary(const std::string& file_name);
/// True while a process on this machine holds its lock; on NFS one on any machine, where locks of
/// files are the server's, but not those of folders.
bool is_being_written(const std::string& temporary);
/// Time by the file system's clock: that of a file made there just now. Times of files are to
/// be compared with this, as clocks of machines differ and jump.
/// @throws Error (Environment) where no file can be made.
std::filesystem::file_time_type time_in(const std::string& folder);

/// @throws Error (Environment) naming it.
void make_folders(const std::string& path);

}  // namespace trivet::farm
