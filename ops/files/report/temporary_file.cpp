#include "ops/files/report/temporary_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace trivet {

TemporaryFile::TemporaryFile(const std::string& bytes, const std::string& suffix) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) folder = "/tmp";
  m_path = (folder / "trivet_XXXXXX").string() + suffix;
  const auto fail = [&](int reason) {
    throw Error(Error::Kind::Environment, "%1: a temporary file cannot be written: %2", m_path,
                std::strerror(reason));
  };
  const int descriptor = mkstemps(m_path.data(), static_cast<int>(suffix.size()));
  if (descriptor < 0) fail(errno);
  close(descriptor);
  std::ofstream file(m_path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return;
  const int reason = errno;
  std::filesystem::remove(m_path, error);
  fail(reason);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(m_path, ignored);
}

}  // namespace trivet
