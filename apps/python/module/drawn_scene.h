// A scene as it is at a call, to be drawn in a thread of its own while others change theirs.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "apps/python/module/shared_scene.h"
#include "ops/files/labels/labelled_scene.h"
#include "ops/files/report/models_of_shapes.h"

namespace trivet::python {

using Names = std::map<std::string, std::string>;
using Colours = std::map<std::string, std::array<float, 4>>;

class DrawnScene {
 public:
  /// @param classes  of objects by their names.
  /// @param highlights  of placed objects by their names.
  /// @throws NoSuchObject (Python) for other names. With the GIL.
  explicit DrawnScene(SharedScene& shared, Names classes = {}, Colours highlights = {});

  /// Work for large meshes, done once; without the GIL.
  LabelledScene& labelled();

 private:
  Scene m_scene;
  Layout m_layout;
  Names m_classes;
  Colours m_highlights;
  std::shared_ptr<DrawnLooks> m_looks;
  std::optional<WholeModels> m_whole;       // of m_scene
  std::optional<LabelledScene> m_labelled;  // of m_whole
};

}  // namespace trivet::python
