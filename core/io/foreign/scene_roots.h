// Folders whose files a scene may name. Scenes are not trusted.
#pragma once

#include <string>
#include <vector>

#include "core/io/model_folder.h"

namespace trivet {

/// The folder of the scene, that of the package around it (the nearest above with a package.xml or
/// a model.config), and those that the caller allows; each with all below it.
class SceneRoots {
 public:
  SceneRoots(const std::string& scene, const std::vector<std::string>& allowed);

  bool holds(const std::string& path) const;
  /// @throws Error (BadInput) naming `named_by` unless the path lies in one of the folders.
  void check(const std::string& path, const std::string& named_by) const;

 private:
  std::vector<ModelFolder> m_folders;
};

}  // namespace trivet
