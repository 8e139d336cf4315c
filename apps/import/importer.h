// What the programs that read one model for another process have in common (core/io/isolated.h).
#pragma once

#include "core/io/model.h"

namespace trivet::apps {

using ModelReader = Model (*)(const std::string& path, const ImportLimits&, const Tessellation&);

/// PATH MAX_FILE_BYTES MAX_TRIANGLES MAX_MEMORY_BYTES CPU_SECONDS CHORD FACET_ANGLE_DEG: puts this
/// process within these limits, reads the model, answers on descriptor 3 and ends the process.
[[noreturn]] void import_and_exit(int argc, char** argv, ModelReader reader);

}  // namespace trivet::apps
