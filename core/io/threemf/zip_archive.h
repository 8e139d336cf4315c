// Entries of ZIP archives (libarchive).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace trivet {

/// The entries that are wanted, by name without a slash at its front.
/// @throws Error (BadInput) naming the file: no archive, damaged, more than so many bytes.
std::map<std::string, std::string> zip_entries(
    const std::string& path, std::string_view bytes, std::uintmax_t max_bytes,
    const std::function<bool(const std::string&)>& wanted);

}  // namespace trivet
