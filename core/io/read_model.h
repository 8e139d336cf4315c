// Models from files, in this process.
#pragma once

#include <cstdint>
#include <string>

#include "core/model/model.h"

namespace trivet {

/// Limits for untrusted files. The last four apply to import_model() (sandboxed_import.h).
struct ImportLimits {
  std::uintmax_t max_file_bytes = std::uintmax_t{4} << 30;
  std::int64_t max_triangles = 50'000'000;
  // Metres per unit of all files, whatever they state; 0: as they state. Of import_model().
  double metres_per_unit = 0;
  // Program trivet-import; empty: import in this process. Builds with Open CASCADE have
  // trivet-import-cad beside it, for STEP, IGES and BREP.
  std::string importer;
  double max_seconds = 0;               // 0: 60, plus one for each MB of the file
  std::uintmax_t max_memory_bytes = 0;  // 0: 1 GiB plus 64 times the file's size
};

/// Reads a model; README.md has the reader of each format. Content decides which it is. Polygons
/// are triangulated without overlap; points, lines and whatever else is left out is noted. STEP,
/// IGES and BREP need import_model().
/// @throws Error (BadInput) naming the file: missing, unreadable, empty, no triangle, coordinates
///   that are not finite (or beyond 1e30), index out of range, larger than the limits.
Model read_model(const std::string& path, const ImportLimits& limits = {});

}  // namespace trivet
