// Formats that Trivet's own readers read, told by content.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/sentence.h"
#include "core/io/read_model.h"

namespace trivet {

enum class ModelFormat { Obj, Stl, Ply, Off, ThreeMf, Gltf, Other };

/// The first bytes decide, not the name; the name decides where bytes say nothing.
/// @param head  the file's first kHeadBytes, text as UTF-8. @param size  of the file, bytes.
/// @param extension  lower_extension().
ModelFormat model_format(std::string_view head, std::uintmax_t size, const std::string& extension);

inline constexpr std::uintmax_t kHeadBytes = 1 << 16;
std::string head_of(const std::string& path);

/// What stands in place of a model, or of a file that a model names: a pointer of Git LFS or a web
/// page. nullopt: neither. @param head  the file's first bytes.
std::optional<Sentence> placeholder(std::string_view head);

/// @param head  the file's first bytes.
/// @throws Error (BadInput) naming the file and what it is: a placeholder, a packed file, a
///   picture, or a CAD file under a name that says otherwise.
void check_is_model(const std::string& path, std::string_view head);

}  // namespace trivet
