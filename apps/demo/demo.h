// The demos: models that Trivet makes itself, and the operations that lay them out.
#pragma once

#include <string>
#include <vector>

#include "core/model/model.h"
#include "ops/files/layout/layout.h"

namespace trivet {

/// A made model under the file name that the layout calls it by; metres, z up.
struct DemoModel {
  std::string file;
  Model model;
};

/// From where a picture of the demo looks best; world, metres.
struct DemoView {
  Vec3 eye, target;
  double fov_deg;  // from the lower to the upper edge, for pictures of about 3 : 2
};

/// A layout that `trivet demo` runs and exports: the layout as a file, the models beside it. The
/// objects' up axis is left to the model, so that made and re-read models stand alike (a glTF file
/// is y up). Each movable object has just one PUT, which is the first that is done with it; what is
/// draped has none.
struct DemoLayout {
  std::string name;
  std::vector<DemoModel> models;
  Layout layout;
  DemoView view;

  /// @throws Error (BadInput) when there is no model under that file name.
  const Model& model(const std::string& file) const;
};

/// "spoon-saucer", "breakfast", "office1" and "office2": the layouts of [Shinya 1995];
/// "tablecloth", "desk" and "towel": what bends; "kitchen": drawers and doors.
std::vector<std::string> demo_names();

/// @throws Error (BadInput) naming the demos there are.
DemoLayout make_demo(const std::string& name);

/// The layout file.
std::string layout_json(const DemoLayout& demo);

}  // namespace trivet
