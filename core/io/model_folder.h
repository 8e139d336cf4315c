// Files that a model names. Models are not trusted: they see their own folder and what is below it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/sentence.h"

namespace trivet {

/// The folder of a model. One that is a symbolic link has two: that of the link, and that of the
/// file to which it leads.
class ModelFolder {
 public:
  explicit ModelFolder(const std::string& model);

  /// True if this path leads to a place in the folder or below it, all symbolic links followed. The
  /// file need not be there.
  bool holds(const std::filesystem::path& file) const;
  /// The same, of a regular file that is there: no folder, device or pipe.
  bool has(const std::filesystem::path& file) const;

  /// One or two, absolute, without links.
  const std::vector<std::filesystem::path>& folders() const { return m_folders; }

 private:
  std::vector<std::filesystem::path> m_folders;  // canonical
};

/// "names "../x.bin", which is outside its folder; accepted: ...". Quotes the model file;
/// does not look whether there is such a file.
Sentence outside_folder(const std::string& name);

}  // namespace trivet
