// Options for scenes of other programs, and opening them.
#pragma once

#include <string>
#include <vector>

#include "apps/trivet/common.h"
#include "ops/files/foreign/open_scene.h"

namespace trivet::apps {

struct ForeignArguments {
  std::string key;
  std::string collide = "engine", rules = "format", rule = "roots";
  std::vector<std::string> fixed, roots;
  std::optional<double> floor;
  bool no_floor = false, free_base = false;
};
void add_foreign_options(CLI::App& app, ForeignArguments& arguments);
OpenOptions open_options(const ForeignArguments& arguments, const CommonOptions& common);

/// True if a file is a scene of another program: not a layout, and not written by Trivet.
bool is_of_others(const std::string& path);

}  // namespace trivet::apps
