#include "core/io/model_folder.h"

#include <algorithm>

#include "core/base/printable.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// Empty: it cannot be told.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  if (error) return {};
  fs::path out = fs::weakly_canonical(whole, error);
  return error ? fs::path() : out;
}

bool is_below(const fs::path& file, const fs::path& folder) {
  const auto end = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end.first == folder.end() && end.second != file.end();
}

}  // namespace

ModelFolder::ModelFolder(const std::string& model) {
  const fs::path parent = fs::path(model).parent_path();
  for (const fs::path& folder :
       {resolved(parent.empty() ? "." : parent), resolved(model).parent_path()})
    if (!folder.empty()) m_folders.push_back(folder);
}

bool ModelFolder::holds(const fs::path& file) const {
  if (file.native().find('\0') != std::string::npos) return false;  // the system reads a part
  const fs::path whole = resolved(file);
  return !whole.empty() && std::any_of(m_folders.begin(), m_folders.end(),
                                       [&](const fs::path& f) { return is_below(whole, f); });
}

bool ModelFolder::has(const fs::path& file) const {
  std::error_code error;
  return holds(file) && fs::is_regular_file(file, error);
}

Sentence outside_folder(const std::string& name) {
  return say(
      "names \"%1\", which is outside its folder; accepted: files in the folder of the model "
      "or below it",
      printable(name, 100));
}

}  // namespace trivet
