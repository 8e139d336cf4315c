// Formats that Trivet's own readers read, told by content.
#pragma once

#include <string>
#include <string_view>

#include "core/io/read_model.h"

namespace trivet {

enum class ModelFormat { Obj, Stl, Ply, Off, ThreeMf, Gltf, Other };

/// The first bytes decide, not the name; the name decides where bytes say nothing.
/// @param head  the file's first kHeadBytes, text as UTF-8. @param size  of the file, bytes.
/// @param extension  lower_extension().
ModelFormat model_format(std::string_view head, std::uintmax_t size, const std::string& extension);

inline constexpr std::uintmax_t kHeadBytes = 1 << 16;

/// @param head  the file's first bytes.
/// @throws Error (BadInput) naming the file and what it is: a pointer of Git LFS, a web page, a
///   packed file, a picture.
void check_is_model(const std::string& path, std::string_view head);

}  // namespace trivet
