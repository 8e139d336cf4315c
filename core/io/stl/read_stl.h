// STL, text and binary.
#pragma once

#include "core/io/surface/file_surface.h"

namespace trivet {

/// True if the bytes are a binary STL: 84 and 50 for each triangle, to the byte.
/// @param head  the first 84 bytes at least, of files that have them. @param size  of the file.
bool is_binary_stl(std::string_view head, std::uintmax_t size);

/// True if text begins with "solid" and has facets.
bool is_text_stl(std::string_view text);

/// Triangles of an STL; the solids of text are nodes. Content decides which kind it is: names of
/// binary ones may begin with "solid", and bytes may stand behind their triangles. Normals repeat
/// the triangles, often wrongly, and are not read.
/// @throws Error (BadInput) naming the file: truncated, no number, neither kind.
FileSurface read_stl(const std::string& path, std::string_view bytes);

}  // namespace trivet
