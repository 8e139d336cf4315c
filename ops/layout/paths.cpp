#include "ops/layout/paths.h"

#include <filesystem>

namespace trivet {

namespace fs = std::filesystem;

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

std::string folder_from(const std::string& from_file, const std::string& to_folder) {
  const auto whole = [](const fs::path& folder) {  // without a slash at the end
    return (fs::absolute(folder.empty() ? "." : folder) / "").lexically_normal().parent_path();
  };
  const fs::path way =
      whole(to_folder).lexically_proximate(whole(fs::path(from_file).parent_path()));
  return way == "." ? "" : way.generic_string();
}

}  // namespace trivet
