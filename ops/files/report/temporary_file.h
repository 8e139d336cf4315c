// A file for those who read only files.
#pragma once

#include <string>

namespace trivet {

/// In the folder for temporary files, readable by the owner only; deleted with the object.
class TemporaryFile {
 public:
  /// @param suffix  such as ".glb".
  /// @throws Error (Environment) when it cannot be written.
  TemporaryFile(const std::string& bytes, const std::string& suffix);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
};

}  // namespace trivet
