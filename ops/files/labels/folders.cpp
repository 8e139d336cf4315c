#include "ops/files/labels/folders.h"

#include <filesystem>

#include "core/base/error.h"

namespace trivet {

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path))
    throw Error(Error::Kind::Environment, "%1: %2", path,
                error ? say("this folder cannot be made: %1", error.message().c_str())
                      : "this folder cannot be made");
}

std::string number_text(int number) {
  std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

}  // namespace trivet
