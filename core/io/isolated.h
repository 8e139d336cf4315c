// Models from files that nobody vouches for: read in a process of their own, within limits.
#pragma once

#include <functional>
#include <string>

#include "core/io/model.h"

namespace trivet {

/// As read_model(), but by the program limits.importer: a file on which the import library crashes,
/// hangs or fills the memory gives an Error, and this process lives on. What comes back is checked
/// as if it were a file. STEP, IGES and BREP are read by the program of that name with "-cad" at
/// its end, where the build had Open CASCADE. Thread-safe.
/// @throws Error: BadInput as read_model(), and for a crash or a limit passed; Environment when the
///   program is missing or cannot be started.
Model read_model_isolated(const std::string& path, const ImportLimits& limits,
                          const Tessellation& tessellation = {});

/// read_model_isolated() if limits.importer names a program, else read_model().
Model import_model(const std::string& path, const ImportLimits& limits,
                   const Tessellation& tessellation = {});

/// What the environment variable TRIVET_IMPORTER names, else trivet-import beside the running
/// program or in the folder above; empty: not found.
std::string find_importer();

/// The other side: writes the model that `read` gives, or its error, to a descriptor.
/// @param path  of the file, for messages.
/// @return the exit status.
int serve_import(const std::function<Model()>& read, const std::string& path,
                 const ImportLimits& limits, int descriptor);

}  // namespace trivet
