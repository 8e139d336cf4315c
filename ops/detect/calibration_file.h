// Keeping a machine's calibration between runs, in the user's cache folder.
#pragma once

#include <string>

#include "ops/detect/calibration.h"

namespace trivet {

/// $XDG_CACHE_HOME/trivet/backends.json, or ~/.cache/trivet/backends.json; empty if neither
/// variable is an absolute path.
std::string calibration_path();

/// As JSON text; doubles come back to the bit.
std::string to_json(const Calibration& calibration);
/// @throws Error (BadInput) naming what is wrong.
Calibration calibration_from_json(const std::string& text);

/// @throws Error (Environment) if it cannot be read, (BadInput) if it is none.
Calibration read_calibration(const std::string& path);
/// Atomically: a reader sees the old file or the new one. Makes the folder.
/// @throws Error (Environment) naming the path and the system's reason.
void write_calibration(const Calibration& calibration, const std::string& path);

}  // namespace trivet
