// Import of STEP, IGES and BREP files, triangulated by Open CASCADE.
#pragma once

#include <string>

#include "core/io/read_model.h"
#include "core/model/model.h"

namespace trivet {

/// Triangles within polygonised->chord of the surfaces, as measured, where Open CASCADE achieves
/// it: the tolerance is reduced until the measurement is within. Faces share the points of their
/// edges, so that solids are closed. Metres (BREP has no unit: millimetres are assumed), z up,
/// rounded to float32. A material per part and colour, named after the part. For untrusted files:
/// call it in a separate process (core/io/process/sandboxed_import.h).
///
/// @throws Error (BadInput) naming the file: unreadable, no face, a chord too small for the model's
///   size, too many triangles. Thread-safety: Open CASCADE's readers keep state in globals; calls
///   wait for one another.
Model read_cad_model(const std::string& path, const ImportLimits& limits = {},
                     const Tessellation& tessellation = {});

}  // namespace trivet
