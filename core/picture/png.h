// Pictures as PNG files.
#pragma once

#include <string>

#include "core/base/image.h"

namespace trivet {

/// Encodes a PNG file; without an alpha channel if every pixel is opaque.
/// @throws Error (Environment) with libpng's reason.
std::string encode_png(const Image& image);

/// Writes a PNG file atomically: the path holds either the old content or the whole picture.
/// @throws Error (Environment) if it cannot be written.
void write_png(const Image& image, const std::string& path);

}  // namespace trivet
