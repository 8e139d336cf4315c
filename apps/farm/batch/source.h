// Scenes of a batch as input of another: of pictures, or of exports.
#pragma once

#include "apps/farm/store/run_file.h"

namespace trivet::farm {

/// The run of a batch of scenes. @throws Error (BadInput) when the folder has none, or another
/// kind.
BatchRun scenes_in(const std::string& folder);

/// The same of the scenes that `run` names. @throws Error (BadInput) when these are others.
BatchRun source_of(const BatchRun& run, const std::string& folder);

/// True if all scenes of a unit of `run` are there. @param scenes  the run in the folder.
bool scenes_are_there(const BatchRun& run, const std::string& folder, const BatchRun& scenes,
                      std::uint64_t unit);

}  // namespace trivet::farm
