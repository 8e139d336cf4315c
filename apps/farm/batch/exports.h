// Batches of simulator files: of the scenes of a batch that is there, or being made.
#pragma once

#include "apps/farm/batch/batch.h"

namespace trivet::farm {

/// Run of a batch of exports, its number of scenes per unit apart.
/// @param scenes  folder of the scenes. @param kinds  of export_kinds().
/// @throws Error (BadInput) when the folder is no batch of scenes.
BatchRun exports_of(const std::string& scenes, const std::vector<std::string>& kinds);

/// Its work; models are read from the store of the scenes, once.
/// @param out  folder of the exports.
/// @throws Error (BadInput) when these are not the scenes that the run names.
Work export_work(const BatchRun& run, const std::string& scenes, const std::string& out,
                 const ImportLimits& import);

}  // namespace trivet::farm
