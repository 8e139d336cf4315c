// An arrangement run from files, for the verbs that do it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/trivet/outputs.h"

namespace trivet::apps {

struct ArrangingOptions {
  std::optional<double> seed;  // instead of the file's
  double seconds = 0;          // of all solutions together; 0: without a limit
  int solutions = 1;
  double distinct = 0.01;  // metres; see ops/arrange/solutions.h
};
void add_arranging_options(CLI::App& app, ArrangingOptions& options);

/// Files of each solution: {} becomes its number, from 1. @throws Error (BadInput) when there are
/// several solutions and a path without {}.
std::vector<OutputPaths> outputs_of_solutions(const OutputPaths& paths,
                                              const ArrangingOptions& arranging);

struct ArrangeFile {
  std::string problem;  // file
  OutputPaths outputs;
  PictureRequest picture = {};
  ModelFolders folders;  // from the scene to the models
};

/// Reads a problem and its models, arranges, and writes the outputs.
/// @return the exit status: 1 for a conflict, and for fewer solutions than asked for.
int arrange_file(const ArrangeFile& file, const ArrangingOptions& arranging,
                 const SettleArguments& settle, const CommonOptions& common);

}  // namespace trivet::apps
