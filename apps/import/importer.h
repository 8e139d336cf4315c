// Common part of the programs that import one model for another process
// (core/io/sandboxed_import.h).
#pragma once

#include "core/io/model.h"

namespace trivet::apps {

using ModelReader = Model (*)(const std::string& path, const ImportLimits&, const Tessellation&);

/// PATH MAX_FILE_BYTES MAX_TRIANGLES MAX_MEMORY_BYTES CPU_SECONDS CHORD FACET_ANGLE_DEG: applies
/// these limits to this process, reads the model, answers on descriptor 3 and exits.
[[noreturn]] void import_and_exit(int argc, char** argv, ModelReader reader);

}  // namespace trivet::apps
