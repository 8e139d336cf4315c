// An arrangement run from files, for the verbs that do it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/trivet/outputs.h"

namespace trivet::apps {

struct ArrangingOptions {
  std::optional<double> seed;  // instead of the file's
  double seconds = 0;          // 0: without a limit
};
void add_arranging_options(CLI::App& app, ArrangingOptions& options);

/// Reads a problem and its models, arranges, and writes the outputs.
/// @param beside  from the scene to the models.   @return the exit status: 1 for a conflict.
int arrange_file(const std::string& file, const ArrangingOptions& arranging,
                 const SettleArguments& settle, const CommonOptions& common, Outputs& outputs,
                 const ModelFolders& beside);

}  // namespace trivet::apps
