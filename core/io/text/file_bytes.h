// Files as bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace trivet {

/// nullopt: it cannot be read, or is larger than the limit.
std::optional<std::string> file_bytes(const std::filesystem::path& file, std::uintmax_t max_bytes);

}  // namespace trivet
