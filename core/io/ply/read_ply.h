// PLY, text and binary.
#pragma once

#include "core/io/surface/file_surface.h"

namespace trivet {

/// Faces and triangle strips of a PLY file with their normals, colours and texture coordinates, in
/// double where the file has doubles or text. Other elements are counted in the notes.
/// @throws Error (BadInput) naming the file: a broken header, truncated data, no number.
FileSurface read_ply(const std::string& path, std::string_view bytes);

}  // namespace trivet
