// Formats that assimp reads, told by content.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trivet {

/// True if the first bytes are those of such a format: Collada, FBX, X3D, VRML, 3DS, LightWave,
/// AC3D and others. @param head  text as UTF-8. @param size  of the file, bytes.
bool tells_other_format(std::string_view head, std::uintmax_t size);

/// True for the extension of a format whose files tell it: others of this name are something else.
bool is_told_by_content(const std::string& extension);

/// The extension under which assimp reads the file: its own, unless the first bytes are those of
/// a format that has others.
std::string other_extension(std::string_view head, std::uintmax_t size,
                            const std::string& extension);

}  // namespace trivet
