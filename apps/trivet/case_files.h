// The files that a command reads, for a repeatable case.
#pragma once

#include <string>
#include <vector>

#include "core/io/read_model.h"

namespace trivet::apps {

/// A layout, arrangement, recipe, journal, scene or model, and every file that it names: models,
/// materials, textures, buffers, a journal's start. Each once, as canonical paths, sorted.
/// A file that cannot be read names nothing: it may be what the case is about.
std::vector<std::string> files_of_case(const std::vector<std::string>& files,
                                       const ImportLimits& limits);

}  // namespace trivet::apps
