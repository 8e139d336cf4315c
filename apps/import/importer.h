// Common part of the programs that import one model for another process
// (core/io/process/sandboxed_import.h).
#pragma once

#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet::apps {

using ModelReader = Model (*)(const std::string& path, const ImportLimits&, const Tessellation&);

/// Arguments: ImportRequest::texts(). Reads the model within these limits, confined as far as the
/// system can (confinement.h), answers on descriptor 3 and exits. Without arguments descriptor 3 is
/// a socket, from which requests are taken (next_request()), each read by a process of its own,
/// until nobody asks any more. kAskProtection: answers only what confines it.
[[noreturn]] void import_and_exit(int argc, char** argv, ModelReader reader);

}  // namespace trivet::apps
