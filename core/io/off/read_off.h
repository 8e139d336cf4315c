// OFF as text.
#pragma once

#include <string>
#include <string_view>

#include "core/io/surface/file_surface.h"

namespace trivet {

/// True if the text begins with a keyword of the format: OFF, COFF, NOFF, STOFF, 4OFF and what they
/// combine to.
bool is_text_off(std::string_view head);

/// Faces of an OFF file with normals, colours and texture coordinates of its vertices and colours
/// of its faces, in double. Keyword, line ends and the number of edges may be missing.
/// @throws Error (BadInput) naming the file: truncated data, no number, binary data.
FileSurface read_off(const std::string& path, std::string_view text);

}  // namespace trivet
