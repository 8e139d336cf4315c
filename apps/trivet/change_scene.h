// Verbs that do one operation to the scene of a file, and write what came of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/trivet/outputs.h"
#include "apps/trivet/verbs.h"

namespace trivet::apps {

/// Arguments common to all of them.
struct SceneArguments {
  std::string scene;
  OutputPaths outputs;
  SettleArguments settle;
};
void add_scene_argument(CLI::App& app, SceneArguments& arguments);
void add_scene_options(CLI::App& app, SceneArguments& arguments);

/// An operation, and the object that it puts if that is new.
struct SceneChange {
  Operation operation;
  std::optional<LayoutObject> entry = {};  // in the layout
  std::optional<Object> object = {};       // in the scene
};

/// @param change  asked for once the scene is read. @return the exit status.
int change_scene(const SceneArguments& arguments, const CommonOptions& common,
                 const std::function<SceneChange(const SceneFile&, const RunOptions&)>& change);

}  // namespace trivet::apps
