#include "ops/files/layout/paths.h"

#include <filesystem>
#include <set>

#include "ops/files/foreign/articulation.h"
#include "ops/files/layout/layout.h"

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

std::vector<std::string> model_files(const Layout& layout, const std::string& folder) {
  std::vector<std::string> out;
  std::set<std::string> known;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && known.insert(name).second)
      out.push_back((fs::path(folder) / name).string());
  };
  add(layout.scene);
  for (const LayoutObject& object : layout.objects) {
    // Links are bodies of one file.
    add(is_link_model(object.model) ? object.model.substr(0, object.model.find('#'))
                                    : object.model);
    add(object.collision);
  }
  for (const Operation& operation : layout.operations)
    if (const auto* const append = std::get_if<AppendOperation>(&operation)) add(append->model);
  return out;
}

}  // namespace trivet
