// Several files that belong together: all of them, or none.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/io/atomic_file.h"

namespace trivet {

/// Files are written beside their targets first, and renamed together at the end: a full disk
/// leaves all as it was. Folders that are made for them vanish again, too.
class StagedFiles {
 public:
  /// @param owner  a model or scene that is replaced, too: its own files may be.
  explicit StagedFiles(std::string owner = {});
  ~StagedFiles();  // deletes files that were not committed
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// A folder for some of them, with those above it; it may be there.
  /// @throws Error (Environment).
  void add_folder(const std::string& path);
  /// As write_file_atomically(), up to the rename; makes missing folders above the file.
  /// @throws Error: BadInput where a model that was read consists of this file (note_opened());
  ///   Environment.
  void add(const std::string& path, const std::string& bytes);
  void add(const std::string& path, const FileContent& content);
  /// A copy of the file `from`, of its own: it shares blocks where the file system has such copies
  /// (FICLONE), but no later change.
  void add_copy(const std::string& path, const std::string& from);
  /// Renames in the order of add(): what names others comes last.
  /// @throws Error (Environment) when the system refuses a rename; those before it are taken back
  ///   (but for files that were replaced where there are no hard links).
  void commit();

 private:
  struct File;
  void check_owner(const std::string& path) const;
  void add_folder_above(const std::string& path);

  std::string m_owner;
  std::vector<std::unique_ptr<File>> m_files;
  std::vector<std::string> m_folders;  // that were made, the outer ones first
};

}  // namespace trivet
