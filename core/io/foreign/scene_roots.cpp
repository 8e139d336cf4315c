#include "core/io/foreign/scene_roots.h"

#include <algorithm>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// A ModelFolder is that of a file.
ModelFolder folder_itself(const fs::path& folder) { return ModelFolder((folder / "any").string()); }

}  // namespace

SceneRoots::SceneRoots(const std::string& scene, const std::vector<std::string>& allowed)
    : m_folders{ModelFolder(scene)} {
  std::error_code error;
  // The package that holds the scene may be read too: the first folder above with its file.
  for (fs::path at = fs::absolute(scene).parent_path(); at.has_relative_path();
       at = at.parent_path())
    if (fs::exists(at / "package.xml", error) || fs::exists(at / "model.config", error)) {
      m_folders.push_back(folder_itself(at));
      break;
    }
  for (const std::string& folder : allowed) {
    if (!fs::is_directory(folder, error))
      bad_input("\"%1\" is no folder; accepted: folders that scenes may read", folder);
    m_folders.push_back(folder_itself(folder));
  }
}

bool SceneRoots::holds(const std::string& path) const {
  return std::any_of(m_folders.begin(), m_folders.end(),
                     [&](const ModelFolder& folder) { return folder.holds(path); });
}

void SceneRoots::check(const std::string& path, const std::string& named_by) const {
  if (!holds(path))
    bad_file(named_by,
             "names \"%1\", which is outside its folder; accepted: files in the folder of the "
             "scene, of its package, or of --root, or below",
             path);
}

}  // namespace trivet
