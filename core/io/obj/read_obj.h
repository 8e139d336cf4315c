// Wavefront OBJ and its materials.
#pragma once

#include "core/io/surface/file_surface.h"

namespace trivet {

/// Polygons of an OBJ file, in any order of its lines: keywords in any case, continued lines,
/// comments behind numbers, negative ids, objects and groups as nodes. Free-form curves and
/// surfaces, lines and points are counted in the notes, and so is whatever else is left out.
/// @param text  UTF-8.
/// @throws Error (BadInput) naming the file and the line: no number, an id out of range.
FileSurface read_obj(const std::string& path, std::string_view text, const ImportLimits& limits);

}  // namespace trivet
