// Verdicts on scenes of other programs, one or many.
#pragma once

#include <string>
#include <vector>

#include "apps/trivet/foreign_scenes.h"
#include "ops/files/foreign/findings.h"

namespace trivet::apps {

struct CheckManyArguments {
  std::vector<std::string> files;
  std::string report;  // lines of JSON; empty: none
  std::string page;    // a page each, with the findings marked; empty: none
  ForeignArguments foreign;
  RunOptions options;
};

/// Judges the files, and tells: one by lines, many by a table, with --json by a line of JSON each.
/// @return the exit status: 0 if all are ok, 1 for findings, 2 if one cannot be read.
int check_many(const CheckManyArguments& arguments, const CommonOptions& common);

/// The scene files in a folder and below, sorted; other paths as they are.
std::vector<std::string> scene_files(const std::vector<std::string>& paths);

}  // namespace trivet::apps
